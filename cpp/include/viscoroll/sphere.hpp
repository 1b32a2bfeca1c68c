/// @file
/// @brief A ball with bonded viscoelastic layers on a rigid core, around a cavity, or down to the center.
#pragma once

#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll {

/// @brief One homogeneous, isotropic, linear viscoelastic layer.
/// Exactly one of `poisson_ratio` and `bulk_modulus` is given.
struct Layer {
  double thickness = 0.0;               ///< [m], at least 1e-9 of the radius of the rolling body
  ShearModulus shear_modulus;           ///< mu*(w) [Pa]
  std::optional<double> poisson_ratio;  ///< [-], real and constant, in (-1, 0.5]; 0.5 is incompressible
  std::optional<double> bulk_modulus;   ///< [Pa], > 0, real and constant: Poisson's ratio then follows from mu*(w)
  double density = 0.0;                 ///< [kg/m^3], >= 0; with 0 there is no inertia

  static constexpr auto fields() {
    return std::tuple{Field{"thickness", &Layer::thickness}, Field{"shear_modulus", &Layer::shear_modulus},
                      Field{"poisson_ratio", &Layer::poisson_ratio}, Field{"bulk_modulus", &Layer::bulk_modulus},
                      Field{"density", &Layer::density, true}};
  }
};

/// @brief Inner boundary of the innermost layer.
enum class InnerBoundary {
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) name,
#include "viscoroll/inner_boundaries.def"
#undef VISCOROLL_INNER_BOUNDARY
};

/// @brief A ball: layers that are bonded to one another and, if there is one, to a rigid core.
///
/// Without a core, the mean rotation of the layers about the center is set to zero, because it cannot be distinguished
/// from the rolling of the ball.
struct CoatedSphere {
  double core_radius = 0.0;                             ///< radius of the core or cavity [m], > 0; 0 for a solid ball
  std::vector<Layer> layers;                            ///< from the center outwards; empty: a rigid ball
  InnerBoundary inner_boundary = InnerBoundary::rigid;  ///< inner boundary of the innermost layer

  static constexpr auto fields() {
    return std::tuple{Field{"core_radius", &CoatedSphere::core_radius, true},
                      Field{"layers", &CoatedSphere::layers, true},
                      Field{"inner_boundary", &CoatedSphere::inner_boundary, true}};
  }
};

/// @brief Curvature terms that the layer equations of a sphere contain. See docs/theory/layers.md.
enum class Curvature {
  sphere,  ///< orders (m, n) of the paper, with the membrane stiffness of a sphere, (k^2 - 2) mu
  paper,   ///< equation (26) of the paper as printed, with k^2 mu; the paper's results were computed with it
  exact,   ///< spherical harmonics in place of the orders (m, n): for thick coatings, hollow and solid balls
};

/// @return outer radius r_o [m]
[[nodiscard]] double outer_radius(const CoatedSphere& sphere);

/// @return total thickness of all layers [m]
[[nodiscard]] double coating_thickness(const CoatedSphere& sphere);

/// @brief Check a layer.
/// @param[in] layer any layer
/// @param[in] prefix text before the parameter's name in messages
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const Layer& layer, std::string_view prefix = "layer.");

/// @brief Check a sphere and its layers, if it has any.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const CoatedSphere& sphere);

}  // namespace viscoroll
