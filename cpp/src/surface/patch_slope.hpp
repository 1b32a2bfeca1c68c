/// @file
/// @brief Slope of a surface along the path, from its values at the nodes.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Mean slope along the path over the patch of each node, which is as long as the distance between rows.
/// It combines the differences over two and four rows so that the error of second order cancels, except next to the
/// first and last row, where there is hardly any pressure. See docs/theory/planes-and-pairs.md.
/// @param[in] values values at the nodes, row by row
/// @param[in] row nodes per row
/// @param[in] distance distance between rows [m]
/// @return slope at every node, 0 in the first and the last row
[[nodiscard]] Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance);

/// @brief Interpolate displacements evaluated downstream of the nodes back to the nodes, by cubics through four rows.
/// @param[in] values values downstream of the nodes, row by row
/// @param[in] row nodes per row
/// @param[in] downstream distance from the nodes, see `SurfaceOperator::collocation` [rows], >= 0
/// @return value at every node; unchanged in the first two rows and the last one, where there is no pressure
[[nodiscard]] Eigen::ArrayXd at_nodes(const Eigen::ArrayXd& values, Eigen::Index row, double downstream);

}  // namespace viscoroll::detail
