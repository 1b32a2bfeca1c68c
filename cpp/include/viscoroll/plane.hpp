/// @file
/// @brief What a body rolls on: an unbounded plane covered by bonded viscoelastic layers.
#pragma once

#include <optional>
#include <vector>

#include "viscoroll/materials.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief Material without end below a plane.
/// Exactly one of `poisson_ratio` and `bulk_modulus` is given.
struct HalfSpace {
  ShearModulus shear_modulus;           ///< mu*(w) [Pa]
  std::optional<double> poisson_ratio;  ///< [-], real and constant, in (-1, 0.5]; 0.5 is incompressible
  std::optional<double> bulk_modulus;   ///< [Pa], > 0, real and constant
  double density = 0.0;                 ///< [kg/m^3], >= 0; 0 leaves inertia out
};

/// @brief Layers bonded to one another and to what carries them. Without layers and without a base it is rigid.
struct CoatedPlane {
  std::vector<Layer> layers;      ///< from the base outwards
  std::optional<HalfSpace> base;  ///< none: rigid
};

/// @brief What a ball rolls in or along, and a roller along: with radii of curvature, > 0 where it is hollow, < 0 where
/// it bulges. Its layers and its base are taken to be flat, as good as they are thin beside the radii.
struct Groove {
  std::optional<double> radius;       ///< across the path [m], larger than the ball's where > 0; none: straight
  std::optional<double> path_radius;  ///< along the path, in its plane [m], likewise: a dish, or the race of a bearing
  CoatedPlane surface;                ///< rigid without layers and base
};

/// @return thickness of all layers together [m]
[[nodiscard]] double coating_thickness(const CoatedPlane& plane);

/// @return whether nothing of the plane deforms
[[nodiscard]] bool is_rigid(const CoatedPlane& plane);
/// @return whether nothing of the groove deforms
[[nodiscard]] bool is_rigid(const Groove& groove);

/// @brief Check a plane, its layers and its base.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const CoatedPlane& plane);

/// @brief Check a groove; whether a ball fits is checked with the ball.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const Groove& groove);

}  // namespace viscoroll
