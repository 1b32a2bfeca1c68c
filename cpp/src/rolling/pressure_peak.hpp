/// @file
/// @brief How well nodes resolve the largest pressure.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace viscoroll::detail {

/// @brief Where material enters the contact faster than it relaxes, pressure rises behind the leading edge within less
/// than a spacing: what nodes see of its peak is an accident. The pressure one spacing ahead of a node, drawn through
/// it and the one behind it, tells of a peak; at a smooth maximum it is too high by the square of the spacing.
/// @param[in] pressure of every node [Pa]
/// @param[in] contact nodes in contact
/// @param[in] stride nodes of a row, which follow one another downstream
/// @return how far the largest of those lies above the largest pressure of a node, relative to it [-], >= 0
[[nodiscard]] double unseen_peak(const Eigen::Ref<const Eigen::ArrayXd>& pressure,
                                 const std::vector<Eigen::Index>& contact, Eigen::Index stride);

}  // namespace viscoroll::detail
