/// @file
/// @brief The layers of a plane, and its base, at all wave numbers.
#pragma once

#include <complex>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "modal/flat_layers.hpp"
#include "modal/layered_surface.hpp"
#include "viscoroll/plane.hpp"

namespace viscoroll::detail {

/// @brief A plane at a list of orders m = k_phi r. Its material crosses the contact at the speed V, and so sees the
/// frequencies k_phi V = m V / r.
class HarmonicPlane final : public LayeredSurface {
 public:
  /// @param[in] plane layers and base, not rigid
  /// @param[in] speed V [m/s], > 0
  /// @param[in] radius r that makes wave numbers orders [m], > 0: that of what rolls
  /// @param[in] orders m > 0
  /// @param[in] measured_order as for `HarmonicCoating`
  /// @throws std::invalid_argument for bad input, at a critical speed, and where a modulus is not passive at an order
  HarmonicPlane(const CoatedPlane& plane, double speed, double radius, std::vector<double> orders,
                double measured_order = std::numeric_limits<double>::infinity());

  /// @brief Base, unless it is rigid, and layers at the i-th order, base outwards.
  [[nodiscard]] std::vector<FlatMedium<std::complex<double>>> media(std::size_t i) const;

  /// @return what the moduli are of: the base, unless it is rigid, as a layer of infinite thickness, and the layers
  [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }

  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] const std::vector<double>& orders() const override { return orders_; }
  [[nodiscard]] std::vector<std::size_t> measured_layers() const override;
  [[nodiscard]] std::complex<double> modulus(std::size_t layer, std::size_t i) const override {
    return moduli_[layer][i];
  }
  [[nodiscard]] std::unique_ptr<LayeredSurface> resampled(std::vector<double> orders,
                                                          const Eigen::ArrayXXcd& measured) const override;
  [[nodiscard]] std::complex<double> outer_modulus(std::size_t i) const override { return moduli_.back()[i]; }
  void compliances(std::span<const OrderAt> orders, std::span<Eigen::Matrix3cd> compliances) const override;

 private:
  std::vector<Layer> layers_;
  double speed_;
  double radius_;
  std::vector<double> orders_;
  std::vector<std::vector<std::complex<double>>> moduli_;  // [layer][order]
};

/// @return the base, unless it is rigid, as a layer of infinite thickness, and the layers
[[nodiscard]] std::vector<Layer> layers_from_base(const CoatedPlane& plane);

}  // namespace viscoroll::detail
