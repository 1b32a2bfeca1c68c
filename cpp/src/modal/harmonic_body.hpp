/// @file
/// @brief A layered body at one speed, with the moduli of its layers at a list of orders.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief Order (m, n), with m given by its index.
struct IndexedOrder {
  std::size_t i;  ///< index of m in `HarmonicBody::orders`
  double n;       ///< order n itself
};

/// @brief Check that a body has at least one layer and that its speed is positive.
/// @throws InvalidInput for a body without layers, and for Omega <= 0 rad/s
void require_layers_and_speed(const LayeredBody& body, double angular_speed);

/// @brief A body whose material crosses the contact at the speed Omega r, where r is the radius of its metric. Order m
/// then has the frequency m Omega.
class HarmonicBody {
 public:
  /// @param[in] body body with at least one layer
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] orders orders m >= 0, on a plane > 0, not necessarily whole numbers
  /// @param[in] measured_order highest order at which measured moduli, `MasterCurve` and `CustomModulus`, are
  /// evaluated; orders above about half of it are replaced by lower ones that approach it smoothly
  /// @throws InvalidInput for invalid input, for a speed at or above the critical one, and for a modulus that
  /// is not passive at an order
  HarmonicBody(LayeredBody body, double angular_speed, std::vector<double> orders,
               double measured_order = std::numeric_limits<double>::infinity());

  [[nodiscard]] const LayeredBody& body() const { return body_; }
  [[nodiscard]] const Metric& metric() const { return body_.metric; }
  [[nodiscard]] double radius() const { return body_.metric.radius; }
  [[nodiscard]] double angular_speed() const { return angular_speed_; }
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }

  /// @return complex shear modulus of a layer at the i-th order [Pa]
  [[nodiscard]] std::complex<double> modulus(std::size_t layer, std::size_t i) const { return moduli_[layer][i]; }
  /// @return complex shear modulus of the outermost layer at the i-th order [Pa]; it makes compliances dimensionless
  [[nodiscard]] std::complex<double> outer_modulus(std::size_t i) const { return moduli_.back()[i]; }
  /// @return largest magnitude of the layers' moduli at the highest order [Pa]
  [[nodiscard]] double stiffest_modulus() const;

  /// @brief The same layers at other orders within the range of the present ones.
  /// @param[in] orders orders m
  /// @param[in] measured measured moduli [Pa], a row for each order and a column for each of `measured_layers`
  [[nodiscard]] HarmonicBody resampled(std::vector<double> orders, const Eigen::ArrayXXcd& measured) const;

  /// @return layers with their moduli at the i-th order
  [[nodiscard]] LayerStack<std::complex<double>> layers_at(std::size_t i) const;

  /// @brief Surface compliances, displacement per surface stress, in the real form of layer_system.hpp.
  /// @param[in] orders orders (m, n); the computation is fastest if consecutive orders have similar m^2 + n^2
  /// @param[out] compliances one for each order [m/Pa]
  void compliances(std::span<const IndexedOrder> orders, std::span<Eigen::Matrix3cd> compliances) const;

  /// @return compliance of one order [m/Pa]
  [[nodiscard]] Eigen::Matrix3cd compliance(const IndexedOrder& order) const;

 private:
  LayeredBody body_;
  double angular_speed_;
  std::vector<double> orders_;
  std::vector<std::vector<std::complex<double>>> moduli_;  // [layer][order]
};

/// @return the body with order m = 0 only, at which the moduli are the relaxed ones
[[nodiscard]] HarmonicBody body_at_order_zero(LayeredBody body, double angular_speed);

/// @brief Reject the exact sphere for computations with orders (m, n).
/// @throws InvalidInput for `Curvature::exact`
void require_orders(Curvature curvature);

/// @brief Layers of a body in units of g, if mu_l*(w) = c_l g(w) at all its orders and all Poisson's ratios are real
/// and constant.
/// @param[in] body body with layers at a list of orders
/// @param[in] reference index of the layer whose modulus is g
/// @param[in] highest_density density for which rho Omega^2 r_o^2 is set to 1 [kg/m^3]; 0: without inertia
/// @return layers; none if there is no such g
[[nodiscard]] std::optional<LayerStack<double>> layers_per_modulus(const HarmonicBody& body, std::size_t reference,
                                                                   double highest_density);

/// @brief Reject a speed at or above the critical speed. For lower speeds the critical speed itself is not computed.
/// @param[in] body layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] highest_frequency frequency at which a `CustomModulus` is evaluated in place of its short-time limit
/// [rad/s]
/// @throws InvalidInput with the critical speed
void require_subcritical(const LayeredBody& body, double angular_speed, double highest_frequency);

/// @brief Reject a speed at which a wave returns around the body with little damping, exp(-pi m tan(delta)).
///
/// At such a speed, order m has no positive stiffness with the storage moduli at its own frequency. The critical speed
/// does not show this if the short-time modulus is high or infinite but is not reached at the frequencies of rolling.
/// @param[in] body body with its orders in ascending order
/// @throws InvalidInput with the order
void require_damped_waves(const HarmonicBody& body);

}  // namespace viscoroll::detail
