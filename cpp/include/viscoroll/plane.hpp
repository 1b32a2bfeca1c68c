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

/// @return thickness of all layers together [m]
[[nodiscard]] double coating_thickness(const CoatedPlane& plane);

/// @return whether nothing of the plane deforms
[[nodiscard]] bool is_rigid(const CoatedPlane& plane);

/// @brief Check a plane, its layers and its base.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const CoatedPlane& plane);

}  // namespace viscoroll
