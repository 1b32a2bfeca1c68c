/// @file
/// @brief A few retardation times common to all orders, and the weights of an order at these times.
///
/// The term 1 / (1 + s lambda) of a retardation time lambda in given intervals is approximated by terms at common times
/// lambda_j, sum phi_j(lambda) / (1 + s lambda_j), with rational functions phi_j. It is exact at s = 0 and at lambda_j:
///
///     1 - (1 + s lambda) sum_j phi_j / (1 + s lambda_j) = s (lambda_n - lambda) / (1 + s lambda_n)
///         prod_{j<n} (lambda - lambda_j) / (lambda + lambda_j) (1 - s lambda_j) / (1 + s lambda_j),
///
/// where lambda_n is the longest time. At real frequencies the last factors have modulus 1, and the first is below 1.
/// The product over the times is therefore the relative error at every frequency, and shows where the next time is
/// needed.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "transient/creep_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Choose times one after another, each where the error of the previous ones is largest.
/// @param[in] intervals intervals of the retardation times, ascending, at least one
/// @param[in] exact times within them that are included in the list, or approximated by it to six digits
/// @param[in] tolerance relative error of 1 / (1 + i w lambda) at any frequency
/// @return common times, ascending [s]
[[nodiscard]] std::vector<double> common_times(std::span<const TimeRange> intervals, std::span<const double> exact,
                                               double tolerance);

/// @return phi_j(lambda) for each of the times; their sum is 1
[[nodiscard]] Eigen::VectorXcd shares(std::span<const double> times, const std::complex<double>& lambda);

/// @brief Points around some intervals. They give sums over the retardation times of an order from its compliance
/// alone: sum_m J_m f(lambda_m) = Re sum_q weight_q f(lambda_q) C(s = -1/lambda_q) for an f that is analytic within the
/// contour and real on the axis.
struct Contour {
  std::vector<std::complex<double>> times;    ///< lambda_q [s]
  std::vector<std::complex<double>> weights;  ///< [-]
};

/// @brief Points of the trapezoidal rule on an ellipse in the plane of ln(lambda).
/// @param[in] intervals intervals that the ellipse encloses
/// @param[in] left -ln of the relative error of the sums
[[nodiscard]] Contour contour_around(std::span<const TimeRange> intervals, double left);

}  // namespace viscoroll::detail
