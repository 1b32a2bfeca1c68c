/// @file
/// @brief Few retardation times that stand for those of all orders, and each time's share in them.
///
/// 1 / (1 + s lambda) at a lambda of some intervals is made of those at the times lambda_j of a list,
/// sum phi_j(lambda) / (1 + s lambda_j), with rational functions phi_j that are exact at s = 0 and at lambda_j:
///
///     1 - (1 + s lambda) sum_j phi_j / (1 + s lambda_j) = s (lambda_n - lambda) / (1 + s lambda_n)
///         prod_{j<n} (lambda - lambda_j) / (lambda + lambda_j) (1 - s lambda_j) / (1 + s lambda_j),
///
/// lambda_n the longest. At real frequencies the last factors are of modulus 1, and the first below 1: the product over
/// the times is the relative error at every frequency, and tells where the next time belongs.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "transient/creep_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Times that are chosen one after another, each where those before it do worst.
/// @param[in] intervals of what they are to stand for, ascending, at least one
/// @param[in] exact times among them that shall be in the list themselves, or stand for by it to six digits
/// @param[in] tolerance relative error of 1 / (1 + i w lambda) at any frequency
/// @return ascending [s]
[[nodiscard]] std::vector<double> common_times(std::span<const TimeRange> intervals, std::span<const double> exact,
                                               double tolerance);

/// @return phi_j(lambda) of each of the times; their sum is 1
[[nodiscard]] Eigen::VectorXcd shares(std::span<const double> times, const std::complex<double>& lambda);

/// @brief Points around some intervals, by which sums over the retardation times of an order are taken from its
/// compliance alone: sum_m J_m f(lambda_m) = Re sum_q weight_q f(lambda_q) C(s = -1/lambda_q), f analytic within and
/// real on the axis.
struct Contour {
  std::vector<std::complex<double>> times;    ///< lambda_q [s]
  std::vector<std::complex<double>> weights;  ///< [-]
};

/// @brief An ellipse in the plane of ln(lambda), with the trapezoidal rule around it.
/// @param[in] intervals which it goes around, all at once
/// @param[in] left -ln of what the rule may leave of a sum
[[nodiscard]] Contour contour_around(std::span<const TimeRange> intervals, double left);

}  // namespace viscoroll::detail
