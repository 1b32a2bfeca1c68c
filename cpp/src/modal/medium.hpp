/// @file
/// @brief Material layers at the frequency of one Fourier order.
#pragma once

#include <cmath>
#include <vector>

#include "modal/metric.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief A layer at one frequency. `Scalar` is double if all moduli are real, else std::complex<double>.
template <class Scalar>
struct Medium {
  double inner;    ///< radius or height of the inner boundary, see `Metric` [m]; -infinity for a half-space
  double outer;    ///< radius or height of the outer boundary [m]
  Scalar mu;       ///< shear modulus [Pa]
  Scalar b;        ///< mu / (lambda + 2 mu), see `shear_ratio`
  double inertia;  ///< rho Omega^2 [Pa/m^2]

  [[nodiscard]] bool is_half_space() const { return std::isinf(inner); }
};

/// @brief The layers of a body at one frequency.
template <class Scalar>
struct LayerStack {
  Metric metric;
  InnerBoundary inner_boundary = InnerBoundary::rigid;  ///< condition below the innermost layer
  std::vector<Medium<Scalar>> media;                    ///< layers from the inside out; a half-space is the first

  /// @return rho (Omega length)^2 / modulus, square of the ratio of the speed of the material to its shear wave speed
  [[nodiscard]] Scalar mach2(const Medium<Scalar>& medium) const {
    const double length = metric.length(medium.outer);
    return medium.inertia * length * length / medium.mu;
  }
};

/// @brief Ratio b of the shear modulus to the confined modulus.
///
/// b = mu / (lambda + 2 mu) = (1 - 2 nu) / (2 (1 - nu)) = mu / (K + 4/3 mu); 0 for an incompressible layer.
/// @param[in] layer layer with a Poisson's ratio nu or a bulk modulus K
/// @param[in] mu shear modulus [Pa]
/// @return ratio [-]
template <class Scalar>
[[nodiscard]] Scalar shear_ratio(const Layer& layer, Scalar mu) {
  if (layer.bulk_modulus) return mu / (*layer.bulk_modulus + 4.0 / 3.0 * mu);
  return Scalar((1.0 - 2.0 * *layer.poisson_ratio) / (2.0 * (1.0 - *layer.poisson_ratio)));
}

}  // namespace viscoroll::detail
