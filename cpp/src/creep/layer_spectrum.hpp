/// @file
/// @brief Creep of layers with different relaxation functions, order by order, at retardation times common to all
/// orders: docs/theory/transient.md, "Layers with different relaxation functions".
///
/// C(k, s) = C_0(k) + sum_j C_j(k) / (1 + s lambda_j). Each order k has times of its own with positive weights. All of
/// them lie in a few intervals, and are replaced by a few times in these intervals that are common to all orders. The
/// times of an order need not be known: sums over them are integrals of C around the intervals that contain them, so
/// that only layers at complex moduli are solved.
///
/// The term 1 / (1 + s lambda) of a retardation time lambda is approximated by terms at the common times lambda_j,
/// sum phi_j(lambda) / (1 + s lambda_j), with rational functions phi_j. It is exact at s = 0 and at lambda_j:
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

#include "materials/creep_spectrum.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief Shear modulus, given by its creep function. It is evaluated at real and complex times -1/s, which take the
/// place of s: a body with discrete times may have retardation times where -1/s is positive.
struct CreepFunction {
  double relaxed;       ///< mu*(0) [Pa]
  CreepSpectrum creep;  ///< times ascending, J_0 > 0

  /// @return mu*(s) at s = -1/time [Pa]
  template <class Scalar>
  [[nodiscard]] Scalar at(const Scalar& time) const {
    Scalar compliance = creep.instantaneous;
    for (std::size_t j = 0; j < creep.size(); ++j) {
      compliance += creep.weights[j] * time / (time - creep.retardation_times[j]);
    }
    return relaxed / compliance;
  }

  /// @return mu*(infinity) [Pa]
  [[nodiscard]] double instantaneous() const { return relaxed / creep.instantaneous; }
};

/// @brief Moduli of layers with their own creep functions.
/// @param[in] layers layers with an instantaneous compliance, which excludes KelvinVoigt
/// @param[in] range in which continuous spectra are resolved
/// @throws InvalidInput for bad parameters
[[nodiscard]] std::vector<CreepFunction> creep_functions(const std::vector<Layer>& layers, const TimeRange& range);

/// @brief Intervals of all retardation times of all orders.
///
/// At s = -1/time every modulus is real, and the energy of an order is a sum over the layers, each with the sign of its
/// modulus. The order can be singular, so that a displacement persists without forces, only if two of these signs
/// differ: docs/theory/transient.md.
/// @param[in] moduli moduli of the layers
/// @param[in] has_elastic_part whether part of the energy is positive at all times, as with bulk moduli
/// @return disjoint intervals, ascending; an interval has zero length if all moduli vanish together at a single time
[[nodiscard]] std::vector<TimeRange> retardation_intervals(std::span<const CreepFunction> moduli,
                                                           bool has_elastic_part);

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
/// @param[in] e_folds -ln of the relative error of the sums
[[nodiscard]] Contour contour_around(std::span<const TimeRange> intervals, double e_folds);

/// @brief An order of a surface, not necessarily an integer.
struct SurfaceOrder {
  double m;  ///< along
  double n;  ///< across
};

/// @brief Layers without inertia as a sum of elastic surfaces, each under forces retarded by one retardation time.
class LayerSpectrum {
 public:
  /// @param[in] body at least one viscoelastic layer; all layers have an instantaneous compliance
  /// @param[in] range times in which continuous spectra are resolved
  /// @param[in] tolerance largest relative error of the compliance of any order at any frequency due to the choice of
  /// times
  /// @throws InvalidInput for bad parameters
  LayerSpectrum(LayeredBody body, const TimeRange& range, double tolerance);

  [[nodiscard]] const Metric& metric() const { return body_.metric; }
  /// @return common times lambda_j, ascending [s]
  [[nodiscard]] const std::vector<double>& retardation_times() const { return times_; }
  /// @return number of weights of an order: one for the instantaneous compliance, and one for each time
  [[nodiscard]] std::size_t weights() const { return times_.size() + 1; }
  /// @return the same plane with orders that refer to another radius [m]; orders of a body around a center refer to its
  /// own radius
  [[nodiscard]] LayerSpectrum with_orders_of(double radius) const;
  /// @return moduli of the layers, from the innermost outwards
  [[nodiscard]] const std::vector<CreepFunction>& moduli() const { return moduli_; }
  /// @return the relaxed body, for the choice of orders
  [[nodiscard]] const LayeredBody& body_at_rest() const { return at_rest_; }

  /// @brief Weights C_0, C_1, ... of orders: displacement per surface stress in the real form of layer_system.hpp.
  /// @param[in] orders faster if neighbors have similar m^2 + n^2
  /// @return [order][weight], symmetric [m/Pa]
  [[nodiscard]] std::vector<std::vector<Eigen::Matrix3d>> weights_of(std::span<const SurfaceOrder> orders) const;

  /// @brief Points around the retardation times of all orders, with their weights in the sums for each common time.
  struct WeighedContour {
    std::vector<std::complex<double>> times;  ///< in place of -1/s [s]
    Eigen::MatrixXcd sums;                    ///< [time][point], of which the real part is used
  };
  /// @param[in] e_folds -ln of the relative error of the sums
  [[nodiscard]] WeighedContour contour(double e_folds) const;
  /// @return the layers at a point of the contour
  [[nodiscard]] LayerStack<std::complex<double>> layers_at(const std::complex<double>& time) const;
  /// @return the layers with their instantaneous moduli
  [[nodiscard]] LayerStack<double> layers_at_once() const;

  /// @return compliance from the weights at a frequency [m/Pa]
  [[nodiscard]] Eigen::Matrix3cd compliance(std::span<const Eigen::Matrix3d> weights, double omega) const;

  /// @brief Largest error of the compliance over orders and frequencies, compared with the moduli themselves.
  /// Off-diagonal entries are relative to the geometric mean of the diagonal entries that they couple [-].
  /// @param[in] range relevant times; frequencies outside a master curve are left out
  [[nodiscard]] double error(const TimeRange& range) const;

 private:
  LayeredBody body_;
  LayeredBody at_rest_;
  std::vector<CreepFunction> moduli_;
  std::vector<double> times_;
  std::vector<LayerStack<std::complex<double>>> on_contour_;  // layers at every point of the contour
  Eigen::MatrixXcd sums_;                                     // weights of the compliances there in the sums
};

/// @return frequencies of a range of times at equal ratios, without those outside a master curve [rad/s]
[[nodiscard]] std::vector<double> compared_frequencies(const std::vector<Layer>& layers, const TimeRange& range);

/// @return orders at equal ratios, for waves from much longer than the total thickness to much shorter than every layer
[[nodiscard]] std::vector<SurfaceOrder> compared_orders(const LayeredBody& body);

/// @return compliance of an order of layers at a frequency, without inertia [m/Pa]
[[nodiscard]] Eigen::Matrix3cd compliance_at(const LayeredBody& body, const SurfaceOrder& order, double omega);

}  // namespace viscoroll::detail
