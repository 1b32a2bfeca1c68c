/// @file
/// @brief How a section's lines of nodes share what columns of nodes across a tread bear and show.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Where columns lie across the tread.
struct TreadColumns {
  int first;       ///< number of the first one, from the middle
  double spacing;  ///< of columns, and width of their patches [m]
};

/// @brief The shares of lines in the means over patches, as far as these lie on the tread.
/// @param[in] lines from the middle of the tread, or as far as its faces are felt, to its face [m]
/// @param[in] columns where they lie
/// @param[in] count of columns
/// @param[in] odd whether what is shared changes its sign from one side of the middle to the other
/// @return [line, column]
[[nodiscard]] Eigen::MatrixXd mean_shares(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                          bool odd);

/// @return the shares of lines in the values in the middle of columns, likewise
[[nodiscard]] Eigen::MatrixXd node_shares(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                          bool odd);

}  // namespace viscoroll::detail
