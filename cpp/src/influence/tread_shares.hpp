/// @file
/// @brief Interpolation across a tread between the lines of nodes of a section and the columns of nodes of a mesh.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Positions of columns across the tread.
struct TreadColumns {
  int first;       ///< number of the first column, from the middle
  double spacing;  ///< distance between columns, and width of their patches [m]
};

/// @brief Weights of lines in the means over patches, within the tread.
/// @param[in] lines positions of the lines [m], ascending to the face, from the middle of the tread or from the
/// distance at which its faces have an effect
/// @param[in] columns positions of the columns
/// @param[in] count number of columns
/// @param[in] odd whether the field changes sign across the middle
/// @return [line, column]
[[nodiscard]] Eigen::MatrixXd mean_shares(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                          bool odd);

/// @return weights of lines in the values at the middle of columns, [line, column]; parameters same as in `mean_shares`
[[nodiscard]] Eigen::MatrixXd node_shares(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                          bool odd);

}  // namespace viscoroll::detail
