/// @file
/// @brief Creep of layers with different relaxation functions, order by order, at retardation times common to all
/// orders.
///
/// C(k, s) = C_0(k) + sum_j C_j(k) / (1 + s lambda_j). Each order k has times of its own with positive weights, which
/// `common_times.hpp` distributes over the common times. The times of the order need not be known: sums over them are
/// integrals of C around the intervals that contain them, so that only layers at complex moduli are solved. See
/// docs/theory/transient.md.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "modal/compliance_recursion.hpp"
#include "modal/layered_body.hpp"
#include "transient/common_times.hpp"
#include "transient/creep_function.hpp"
#include "transient/layer_frequencies.hpp"

namespace viscoroll::detail {

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
  /// @param[in] left -ln of the relative error of the sums
  [[nodiscard]] WeighedContour contour(double left) const;
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

/// @return compliance of an order of layers at a frequency, without inertia [m/Pa]
[[nodiscard]] Eigen::Matrix3cd compliance_at(const LayeredBody& body, const SurfaceOrder& order, double omega);

}  // namespace viscoroll::detail
