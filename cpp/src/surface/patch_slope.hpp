/// @file
/// @brief Slope of a surface along the path, from its values at the nodes.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Mean slope from row to row over the patches of nodes, which are as long as their distance: of the differences
/// over two rows and over four what leaves no error of second order, but for the last two rows, where hardly anything
/// presses. See docs/theory/planes-and-pairs.md.
/// @param[in] values at the nodes, row by row
/// @param[in] row nodes in a row
/// @param[in] distance of rows [m]
/// @return at every node, 0 in the first and the last row
[[nodiscard]] Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance);

/// @brief What displacements that are taken downstream of the nodes are at these, by cubics through four rows.
/// @param[in] values downstream of the nodes, row by row
/// @param[in] row nodes in a row
/// @param[in] downstream by how much, see `SurfaceOperator::collocation` [rows], >= 0
/// @return at every node; in the first two and the last row, where nothing presses, as they are
[[nodiscard]] Eigen::ArrayXd at_nodes(const Eigen::ArrayXd& values, Eigen::Index row, double downstream);

}  // namespace viscoroll::detail
