/// @file
/// @brief Gauss-Legendre quadrature, and associated Legendre functions of one order and many degrees.
#pragma once

#include <Eigen/Core>
#include <utility>

namespace viscoroll::detail {

/// @return abscissas on [-1, 1] and weights, from the eigenvalues of the Jacobi matrix (Golub and Welsch, 1969)
[[nodiscard]] std::pair<Eigen::ArrayXd, Eigen::ArrayXd> gauss_legendre(int points);

/// @brief Functions P_lm(theta), normalized so that the integral of P^2 sin(theta) over [0, pi] is 1, without the sign
/// (-1)^m. There is one row per degree m, m + 1, ... and one column per angle.
struct LegendreFunctions {
  Eigen::MatrixXd value;
  Eigen::MatrixXd slope;  ///< dP/dtheta

  /// @brief Compute the functions by the recurrence in the degree, which is stable.
  /// Near the poles the first functions underflow; they have separate exponents (T. Fukushima, J. Geod. 86 (2012)
  /// 271-285).
  /// @param[in] order m >= 0
  /// @param[in] highest highest degree, >= m
  /// @param[in] theta angles in (0, pi) [rad]
  LegendreFunctions(int order, int highest, const Eigen::ArrayXd& theta);
};

}  // namespace viscoroll::detail
