/// @file
/// @brief The rolling body: a rigid core covered by bonded viscoelastic layers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll {

/// @brief One homogeneous, isotropic, linear viscoelastic layer.
/// Exactly one of `poisson_ratio` and `bulk_modulus` is given.
struct Layer {
  double thickness = 0.0;               ///< [m], at least 1e-9 of the radius of the rolling body
  ShearModulus shear_modulus;           ///< mu*(w) [Pa]
  std::optional<double> poisson_ratio;  ///< [-], real and constant, in (-1, 0.5]; 0.5 is incompressible
  std::optional<double> bulk_modulus;   ///< [Pa], > 0, real and constant: Poisson's ratio then follows mu*(w)
  double density = 0.0;                 ///< [kg/m^3], >= 0; 0 leaves inertia out
};

/// @brief What lies within the innermost layer.
enum class InnerBoundary {
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) name,
#include "viscoroll/inner_boundaries.def"
#undef VISCOROLL_INNER_BOUNDARY
};

/// @brief Layers bonded to one another, and to a rigid core if there is one. Without a core, the coating's mean
/// rotation about the center is taken to be zero, for no other can be told from turning the sphere.
struct CoatedSphere {
  double core_radius = 0.0;                             ///< of the core or the cavity [m], > 0; 0 for a solid ball
  std::vector<Layer> layers;                            ///< from the center outwards; none: a rigid ball
  InnerBoundary inner_boundary = InnerBoundary::rigid;  ///< what lies within
};

/// @brief How much of the sphere's curvature the equations of the layers keep. See docs/theory/layers.md.
enum class Curvature {
  sphere,  ///< the paper's orders (m, n) with the membrane stiffness of a sphere, (k^2 - 2) mu
  paper,   ///< equation (26) as printed, k^2 mu, with which the paper's tables were made
  exact,   ///< spherical harmonics in place of the orders (m, n): thick coatings, hollow and solid balls
};

/// @return outer radius r_o [m]
[[nodiscard]] double outer_radius(const CoatedSphere& sphere);

/// @return thickness of all layers together [m]
[[nodiscard]] double coating_thickness(const CoatedSphere& sphere);

/// @brief Check a layer.
/// @param[in] layer any layer
/// @param[in] prefix what stands before the parameter's name in messages
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const Layer& layer, std::string_view prefix = "layer.");

/// @brief Check a sphere and its layers, if it has some.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const CoatedSphere& sphere);

}  // namespace viscoroll
