/// @file
/// @brief A layered body at a speed, as a list of orders sees it.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief An order (m, n), m by its number in a list.
struct OrderAt {
  std::size_t i;
  double n;
};

/// @brief Check what is about to roll, or to be rolled on: at least one layer, and a speed Omega > 0 [rad/s].
/// @throws std::invalid_argument
void require_rolling(const LayeredBody& body, double angular_speed);

/// @brief A body whose material crosses the contact at Omega r, r the radius of its metric, and so sees order m at the
/// frequency m Omega.
class HarmonicBody {
 public:
  /// @param[in] body at least one layer
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] orders m >= 0, > 0 on a plane, not necessarily whole
  /// @param[in] measured_order materials that were measured, `MasterCurve` and `CustomModulus`, are not asked for
  /// frequencies beyond this order's: from about half of it on they are taken at lower ones
  /// @throws std::invalid_argument for bad input, at a critical speed, and where a modulus is not passive at an order
  HarmonicBody(LayeredBody body, double angular_speed, std::vector<double> orders,
               double measured_order = std::numeric_limits<double>::infinity());

  [[nodiscard]] const LayeredBody& body() const { return body_; }
  [[nodiscard]] const Metric& metric() const { return body_.metric; }
  [[nodiscard]] double radius() const { return body_.metric.radius; }
  [[nodiscard]] double angular_speed() const { return angular_speed_; }
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }

  /// @return complex shear modulus of a layer at the i-th order [Pa]
  [[nodiscard]] std::complex<double> modulus(std::size_t layer, std::size_t i) const { return moduli_[layer][i]; }
  /// @return that of the outermost layer, by which compliances are scaled
  [[nodiscard]] std::complex<double> outer_modulus(std::size_t i) const { return moduli_.back()[i]; }
  /// @return the largest one of a layer at the highest order [Pa]
  [[nodiscard]] double stiffest_modulus() const;

  /// @brief The same layers at other orders, within the range of these.
  /// @param[in] orders m
  /// @param[in] measured moduli that were measured, a row for each order and a column for each of `measured_layers`
  [[nodiscard]] HarmonicBody resampled(std::vector<double> orders, const Eigen::ArrayXXcd& measured) const;

  /// @return the layers as the i-th order sees them
  [[nodiscard]] LayerStack<std::complex<double>> layers_at(std::size_t i) const;

  /// @brief Displacement per surface stress in the real form of layer_system.hpp.
  /// @param[in] orders best with neighbors of like m^2 + n^2
  /// @param[out] compliances one for each [m/Pa]
  void compliances(std::span<const OrderAt> orders, std::span<Eigen::Matrix3cd> compliances) const;

  /// @return the compliance of one order [m/Pa]
  [[nodiscard]] Eigen::Matrix3cd compliance(const OrderAt& order) const;

 private:
  LayeredBody body_;
  double angular_speed_;
  std::vector<double> orders_;
  std::vector<std::vector<std::complex<double>>> moduli_;  // [layer][order]
};

/// @return the body at order 0 alone
[[nodiscard]] HarmonicBody body_at_rest(LayeredBody body, double angular_speed);

/// @brief Refuse the exact sphere where orders (m, n) are asked for.
/// @throws std::invalid_argument
void require_orders(Curvature curvature);

}  // namespace viscoroll::detail
