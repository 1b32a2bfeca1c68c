/// @file
/// @brief The surface of a layered body, sphere or plane, as a list of orders sees it.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace viscoroll::detail {

/// @brief An order (m, n), m by its number in a list.
struct OrderAt {
  std::size_t i;
  double n;
};

/// @brief Compliances at orders m = k_phi r of a list and any orders n, r a radius that makes wave numbers orders.
class LayeredSurface {
 public:
  virtual ~LayeredSurface() = default;

  /// @return the orders m
  [[nodiscard]] virtual const std::vector<double>& orders() const = 0;

  /// @return layers of which the modulus was measured, and so may have kinks
  [[nodiscard]] virtual std::vector<std::size_t> measured_layers() const = 0;

  /// @return complex shear modulus of a layer at the i-th order [Pa]
  [[nodiscard]] virtual std::complex<double> modulus(std::size_t layer, std::size_t i) const = 0;

  /// @brief The same layers at other orders, within the range of these.
  /// @param[in] orders m
  /// @param[in] measured moduli that were measured, a row for each order and a column for each of `measured_layers`
  [[nodiscard]] virtual std::unique_ptr<LayeredSurface> resampled(std::vector<double> orders,
                                                                  const Eigen::ArrayXXcd& measured) const = 0;

  /// @return modulus of the outermost material at the i-th order [Pa], by which compliances are scaled
  [[nodiscard]] virtual std::complex<double> outer_modulus(std::size_t i) const = 0;

  /// @brief Displacement per surface stress in the real form of layer_system.hpp.
  /// @param[in] orders best with neighbors of like m^2 + n^2
  /// @param[out] compliances one for each [m/Pa]
  virtual void compliances(std::span<const OrderAt> orders, std::span<Eigen::Matrix3cd> compliances) const = 0;
};

}  // namespace viscoroll::detail
