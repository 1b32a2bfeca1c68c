/// @file
/// @brief One layer as the material of one order sees it, and the layers of a coating at all harmonics.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "modal/layered_surface.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief A layer at one frequency. `Scalar` is double where every modulus is real, else std::complex<double>.
template <class Scalar>
struct Medium {
  double inner_radius;  ///< [m]
  double outer_radius;  ///< [m]
  Scalar mu;            ///< shear modulus [Pa]
  Scalar b;             ///< mu / (lambda + 2 mu), see `shear_ratio`
  double inertia;       ///< rho Omega^2 [Pa/m^2]
  /// What lies within it: `rigid` stands for whatever carries it, the layer below included.
  InnerBoundary within = InnerBoundary::rigid;
  Curvature curvature = Curvature::sphere;
};

/// @brief Below this k^2 a torus has orders that no sphere has: those of a sphere start at L = 2, its rigid motions.
constexpr double kLowOrders = 4.0;

/// @brief What the surface of a sphere adds to the stiffness against tangential displacements, per mu: L - 2 on a
/// sphere, where L = 2 are rigid motions; k^2 in the paper's equation (26). Theory.md section 3.
/// @param[in] curvature which of them
/// @param[in] k2 k^2 = m^2 + n^2; L = l (l + 1) of the exact sphere
[[nodiscard]] constexpr double membrane_stiffness(Curvature curvature, double k2) {
  switch (curvature) {
    case Curvature::paper:
      return k2;
    case Curvature::exact:
      return k2 - 2.0;
    default:
      return k2 < kLowOrders ? 0.5 * k2 : k2 - 2.0;
  }
}

/// @brief Ratio b of the shear modulus to the confined modulus, mu / (lambda + 2 mu) = (1 - 2 nu) / (2 (1 - nu)) =
/// mu / (K + 4/3 mu): 0 where the layer is incompressible.
/// @param[in] layer gives its Poisson's ratio nu or its bulk modulus K, whichever it has
/// @param[in] mu shear modulus [Pa]
template <class Scalar>
[[nodiscard]] Scalar shear_ratio(const Layer& layer, Scalar mu) {
  if (layer.bulk_modulus) return mu / (*layer.bulk_modulus + 4.0 / 3.0 * mu);
  return Scalar((1.0 - 2.0 * *layer.poisson_ratio) / (2.0 * (1.0 - *layer.poisson_ratio)));
}

/// @brief Complex shear moduli of layers at the frequencies m Omega.
/// @param[in] layers of a coating
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] orders m >= 0, not necessarily whole
/// @param[in] measured_order materials that were measured, `MasterCurve` and `CustomModulus`, are not asked for
/// frequencies beyond this order's: from about half of it on they are taken at lower ones
/// @return [layer][order] [Pa]
[[nodiscard]] std::vector<std::vector<std::complex<double>>> harmonic_moduli(const std::vector<Layer>& layers,
                                                                             double angular_speed,
                                                                             const std::vector<double>& orders,
                                                                             double measured_order);

/// @return the highest frequency at which measured materials are asked for theirs [rad/s]
[[nodiscard]] double highest_frequency(double angular_speed, const std::vector<double>& orders, double measured_order);

/// @return whether a modulus was measured, and so may have kinks
[[nodiscard]] bool is_measured(const ShearModulus& modulus);

/// @return those of some layers
[[nodiscard]] std::vector<std::size_t> measured_layers(const std::vector<Layer>& layers);

/// @brief Moduli of layers at other orders.
/// @param[in] layers of a body
/// @param[in] frequencies of the orders [rad/s]
/// @param[in] measured moduli that were measured, a row for each order and a column for each of `measured_layers`
/// @return [layer][order] [Pa]
[[nodiscard]] std::vector<std::vector<std::complex<double>>> resampled_moduli(const std::vector<Layer>& layers,
                                                                              const std::vector<double>& frequencies,
                                                                              const Eigen::ArrayXXcd& measured);

/// @return an order that approaches a limit smoothly: series over such orders stay smooth
[[nodiscard]] double limited(double order, double limit);

/// @brief The layers of a coating at a list of orders m, whose material sees the frequencies m Omega.
class HarmonicCoating final : public LayeredSurface {
 public:
  /// @param[in] sphere rigid core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] orders m >= 0, not necessarily whole
  /// @param[in] measured_order materials that were measured, `MasterCurve` and `CustomModulus`, are not asked for
  /// frequencies beyond this order's: from about half of it on they are taken at lower ones
  /// @param[in] curvature how much of it the equations keep
  /// @throws std::invalid_argument for bad input, at a critical speed, and where a modulus is not passive at an order
  HarmonicCoating(const CoatedSphere& sphere, double angular_speed, std::vector<double> orders,
                  double measured_order = std::numeric_limits<double>::infinity(),
                  Curvature curvature = Curvature::sphere);

  /// @brief Layers at the i-th order, core outwards.
  [[nodiscard]] std::vector<Medium<std::complex<double>>> media(std::size_t i) const;

  [[nodiscard]] const std::vector<double>& orders() const override { return orders_; }
  [[nodiscard]] std::vector<std::size_t> measured_layers() const override;
  [[nodiscard]] std::complex<double> modulus(std::size_t layer, std::size_t i) const override {
    return moduli_[layer][i];
  }
  [[nodiscard]] std::unique_ptr<LayeredSurface> resampled(std::vector<double> orders,
                                                          const Eigen::ArrayXXcd& measured) const override;
  [[nodiscard]] std::complex<double> outer_modulus(std::size_t i) const override { return moduli_.back()[i]; }
  void compliances(std::span<const OrderAt> orders, std::span<Eigen::Matrix3cd> compliances) const override;

  [[nodiscard]] const CoatedSphere& sphere() const { return sphere_; }
  [[nodiscard]] double outer_radius() const { return radii_.back(); }
  [[nodiscard]] double angular_speed() const { return angular_speed_; }
  [[nodiscard]] Curvature curvature() const { return curvature_; }

 private:
  CoatedSphere sphere_;
  double angular_speed_;
  std::vector<double> orders_;
  Curvature curvature_;
  std::vector<double> radii_;                              // interfaces, core to surface [m]
  std::vector<std::vector<std::complex<double>>> moduli_;  // [layer][order]
};

/// @return the coating at order 0 alone
[[nodiscard]] HarmonicCoating coating_at_rest(const CoatedSphere& sphere, double angular_speed, Curvature curvature);

/// @brief Refuse the exact sphere where orders (m, n) are asked for.
/// @throws std::invalid_argument
void require_orders(Curvature curvature);

}  // namespace viscoroll::detail
