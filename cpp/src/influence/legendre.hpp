/// @file
/// @brief Gauss-Legendre quadrature, and associated Legendre functions of one order and many degrees.
#pragma once

#include <Eigen/Core>
#include <utility>

namespace viscoroll::detail {

/// @return abscissas on [-1, 1] and weights, from the eigenvalues of the Jacobi matrix (Golub and Welsch, 1969)
[[nodiscard]] std::pair<Eigen::ArrayXd, Eigen::ArrayXd> gauss_legendre(int points);

/// @brief Functions P_lm(theta), normalized so that the integral of P^2 sin(theta) over [0, pi] is 1. They do not
/// contain the factor (-1)^m (Condon-Shortley). There is one row for each degree l = m, m + 1, ..., where m is the
/// order, and one column for each angle.
struct LegendreFunctions {
  Eigen::MatrixXd value;
  Eigen::MatrixXd slope;  ///< dP/dtheta

  /// @brief Compute the functions by the recurrence in the degree, which is stable.
  /// Near the poles, the functions of the lowest degrees are below the range of double. The recurrence therefore
  /// carries a separate exponent (T. Fukushima, J. Geod. 86 (2012) 271-285), and returns 0 for values below the range.
  /// @param[in] order m >= 0
  /// @param[in] highest highest degree, >= m
  /// @param[in] theta angles in (0, pi) [rad]
  LegendreFunctions(int order, int highest, const Eigen::ArrayXd& theta);
};

}  // namespace viscoroll::detail
