/// @file
/// @brief Gauss-Legendre quadrature.
#pragma once

#include <Eigen/Core>
#include <utility>

namespace viscoroll::detail {

/// @return abscissas on [-1, 1] and weights, from the eigenvalues of the Jacobi matrix (Golub and Welsch, 1969)
[[nodiscard]] std::pair<Eigen::ArrayXd, Eigen::ArrayXd> gauss_legendre(int points);

}  // namespace viscoroll::detail
