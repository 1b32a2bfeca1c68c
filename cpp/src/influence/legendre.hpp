/// @file
/// @brief Associated Legendre functions of one order and many degrees.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Functions P_lm(theta), normalized so that the integral of P^2 sin(theta) over [0, pi] is 1 and without the
/// sign
/// (-1)^m; a row for each degree m, m + 1, ..., a column for each angle.
struct LegendreFunctions {
  Eigen::MatrixXd value;
  Eigen::MatrixXd slope;  ///< dP/dtheta

  /// @brief By the recurrence in the degree, which is stable. Near the poles the first ones are smaller than any
  /// double; they are carried with exponents of their own (T. Fukushima, J. Geod. 86 (2012) 271-285).
  /// @param[in] order m >= 0
  /// @param[in] highest degree, >= m
  /// @param[in] theta angles in (0, pi) [rad]
  LegendreFunctions(int order, int highest, const Eigen::ArrayXd& theta);
};

}  // namespace viscoroll::detail
