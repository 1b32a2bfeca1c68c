/// @file
/// @brief Error of the largest pressure due to the spacing of the nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace viscoroll::detail {

/// @brief Excess of a pressure peak that may lie between the nodes.
///
/// If material enters the contact faster than it relaxes, the pressure rises behind the leading edge within less than a
/// spacing, and the nodes resolve its peak only by chance. The pressure extrapolated to one spacing ahead of a node,
/// from this node and the one behind it, indicates such a peak. At a smooth maximum the extrapolation is too high by a
/// term of the order of the spacing squared.
/// @param[in] pressure of every node [Pa]
/// @param[in] contact nodes in contact
/// @param[in] stride nodes of a row; the rows follow one another downstream
/// @return excess of the largest extrapolated pressure over the largest pressure of a node, relative to the latter [-],
/// >= 0
[[nodiscard]] double unresolved_peak(const Eigen::Ref<const Eigen::ArrayXd>& pressure,
                                     const std::vector<Eigen::Index>& contact, Eigen::Index stride);

}  // namespace viscoroll::detail
