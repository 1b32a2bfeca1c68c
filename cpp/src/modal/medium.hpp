/// @file
/// @brief Layers as the material of one order sees them.
#pragma once

#include <cmath>
#include <vector>

#include "modal/metric.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief A layer at one frequency. `Scalar` is double where every modulus is real, else std::complex<double>.
template <class Scalar>
struct Medium {
  double inner;    ///< place along the normal, see `Metric` [m]; -infinity of a half-space, which comes first
  double outer;    ///< [m]
  Scalar mu;       ///< shear modulus [Pa]
  Scalar b;        ///< mu / (lambda + 2 mu), see `shear_ratio`
  double inertia;  ///< rho Omega^2 [Pa/m^2]

  [[nodiscard]] bool is_endless() const { return std::isinf(inner); }
};

/// @brief The layers of a body at one frequency.
template <class Scalar>
struct LayerStack {
  Metric metric;
  InnerBoundary within = InnerBoundary::rigid;  ///< the innermost layer: a core, or the base of a plane
  std::vector<Medium<Scalar>> media;            ///< from there outwards

  /// @return rho (Omega length)^2 per modulus: the square of the speed of the material per that of its shear waves
  [[nodiscard]] Scalar mach2(const Medium<Scalar>& medium) const {
    const double length = metric.length(medium.outer);
    return medium.inertia * length * length / medium.mu;
  }
};

/// @brief Ratio b of the shear modulus to the confined modulus, mu / (lambda + 2 mu) = (1 - 2 nu) / (2 (1 - nu)) =
/// mu / (K + 4/3 mu): 0 where the layer is incompressible.
/// @param[in] layer gives its Poisson's ratio nu or its bulk modulus K, whichever it has
/// @param[in] mu shear modulus [Pa]
template <class Scalar>
[[nodiscard]] Scalar shear_ratio(const Layer& layer, Scalar mu) {
  if (layer.bulk_modulus) return mu / (*layer.bulk_modulus + 4.0 / 3.0 * mu);
  return Scalar((1.0 - 2.0 * *layer.poisson_ratio) / (2.0 * (1.0 - *layer.poisson_ratio)));
}

}  // namespace viscoroll::detail
