/// @file
/// @brief Nonnegative linear least squares.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Minimize |A x - b| with x >= 0, by the active set of C. L. Lawson and R. J. Hanson, Solving Least Squares
/// Problems (1974), chapter 23.
/// @param[in] matrix A
/// @param[in] right b
/// @return x
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace viscoroll::detail
