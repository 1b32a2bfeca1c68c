/// @file
/// @brief Interpolation across a tread between the lines of nodes of a section and the columns of nodes of a mesh.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Positions of columns across the tread.
struct TreadColumns {
  int first;       ///< number of the first column; column 0 is in the middle of the tread
  double spacing;  ///< distance between columns, and width of their patches [m]
};

/// @brief Weights with which the values on the lines enter the mean of a field over the patch of each column. The patch
/// is cut off at the faces of the tread.
/// @param[in] lines distances of the lines from the middle of the tread [m], ascending; the last line is at the face.
/// The first is in the middle, or where the effect of the faces begins; positions nearer to the middle have zero
/// weights.
/// @param[in] columns positions of the columns
/// @param[in] count number of columns
/// @param[in] odd whether the field changes sign across the middle
/// @return [line, column]
[[nodiscard]] Eigen::MatrixXd patch_mean_weights(const Eigen::ArrayXd& lines, const TreadColumns& columns,
                                                 Eigen::Index count, bool odd);

/// @return weights with which the values on the lines enter the value in the middle of each column, [line, column];
/// parameters same as in `patch_mean_weights`
[[nodiscard]] Eigen::MatrixXd node_weights(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                           bool odd);

}  // namespace viscoroll::detail
