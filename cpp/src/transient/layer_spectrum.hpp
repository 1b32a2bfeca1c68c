/// @file
/// @brief Creep of layers that share no relaxation function, order by order, at retardation times common to all orders.
///
/// C(k, s) = C_0(k) + sum_j C_j(k) / (1 + s lambda_j). An order k of its own has its own times, and positive weights at
/// them; `common_times.hpp` shares these out. The order's times need not be known for it: sums over them are integrals
/// of C around the intervals where they lie, so that layers solved at complex moduli are all it takes.
/// See docs/theory/transient.md.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "modal/compliance_recursion.hpp"
#include "modal/layered_body.hpp"
#include "transient/common_times.hpp"
#include "transient/creeping_modulus.hpp"
#include "transient/layer_frequencies.hpp"

namespace viscoroll::detail {

/// @brief Layers without inertia as a sum of elastic surfaces whose forces lag by one retardation time each.
class LayerSpectrum {
 public:
  /// @param[in] body at least one layer that creeps, and none that does not yield at once
  /// @param[in] range of times that continuous spectra are resolved in
  /// @param[in] tolerance relative error of the compliance of any order at any frequency that the choice of times may
  /// leave
  /// @throws std::invalid_argument for bad parameters
  LayerSpectrum(LayeredBody body, const TimeRange& range, double tolerance);

  [[nodiscard]] const Metric& metric() const { return body_.metric; }
  /// @return lambda_j, ascending [s]
  [[nodiscard]] const std::vector<double>& retardation_times() const { return times_; }
  /// @return number of weights of an order: one for what yields at once, and one for each time
  [[nodiscard]] std::size_t weights() const { return times_.size() + 1; }
  /// @return the same plane, whose wave numbers are orders at another radius [m]; a body around a center has its own
  [[nodiscard]] LayerSpectrum with_orders_of(double radius) const;
  /// @return those of the layers, outwards
  [[nodiscard]] const std::vector<CreepingModulus>& moduli() const { return moduli_; }
  /// @return relaxed, for the choice of orders
  [[nodiscard]] const LayeredBody& body_at_rest() const { return at_rest_; }

  /// @brief C_0, C_1, ... of orders: displacement per surface stress in the real form of layer_system.hpp.
  /// @param[in] orders best with neighbors of like m^2 + n^2
  /// @return [order][weight], symmetric [m/Pa]
  [[nodiscard]] std::vector<std::vector<Eigen::Matrix3d>> weights_of(std::span<const SurfaceOrder> orders) const;

  /// @brief Points around the retardation times of all orders, and what sums over these take of what an order is there.
  struct WeighedContour {
    std::vector<std::complex<double>> times;  ///< in place of -1/s [s]
    Eigen::MatrixXcd sums;                    ///< [time][point], of which the real part is taken
  };
  /// @param[in] left -ln of what sums may leave
  [[nodiscard]] WeighedContour contour(double left) const;
  /// @return the layers at one of its points,
  [[nodiscard]] LayerStack<std::complex<double>> layers_at(const std::complex<double>& time) const;
  /// @return and as they yield at once
  [[nodiscard]] LayerStack<double> layers_at_once() const;

  /// @return the compliance that the weights stand for, at a frequency [m/Pa]
  [[nodiscard]] Eigen::Matrix3cd compliance(std::span<const Eigen::Matrix3d> weights, double omega) const;

  /// @return largest error of the compliance over orders and frequencies, as against the moduli themselves; entries
  /// off the diagonal relative to what they couple [-]
  /// @param[in] range of the times asked for; frequencies that a master curve refuses are not
  [[nodiscard]] double error(const TimeRange& range) const;

 private:
  LayeredBody body_;
  LayeredBody at_rest_;
  std::vector<CreepingModulus> moduli_;
  std::vector<double> times_;
  std::vector<LayerStack<std::complex<double>>> on_contour_;  // layers at every point of the contour,
  Eigen::MatrixXcd sums_;                                     // and what sums take of compliances there
};

/// @return the compliance of an order of layers at a frequency, without inertia [m/Pa]
[[nodiscard]] Eigen::Matrix3cd compliance_at(const LayeredBody& body, const SurfaceOrder& order, double omega);

}  // namespace viscoroll::detail
