/// @file
/// @brief Planes and grooves as counterbodies.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "viscoroll/materials.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief A homogeneous half-space. Exactly one of `poisson_ratio` and `bulk_modulus` is given.
struct HalfSpace {
  ShearModulus shear_modulus;           ///< mu*(w) [Pa]
  std::optional<double> poisson_ratio;  ///< [-], real and constant, in (-1, 0.5]; 0.5 is incompressible
  std::optional<double> bulk_modulus;   ///< [Pa], > 0, real and constant
  double density = 0.0;                 ///< [kg/m^3], >= 0; with 0 there is no inertia

  static constexpr auto fields() {
    return std::tuple{Field{"shear_modulus", &HalfSpace::shear_modulus},
                      Field{"poisson_ratio", &HalfSpace::poisson_ratio},
                      Field{"bulk_modulus", &HalfSpace::bulk_modulus}, Field{"density", &HalfSpace::density, true}};
  }
};

/// @brief An unbounded plane: layers that are bonded to one another and to a base. Without layers and without a base
/// the plane is rigid.
struct CoatedPlane {
  std::vector<Layer> layers;      ///< from the base outwards
  std::optional<HalfSpace> base;  ///< none: a rigid base

  static constexpr auto fields() {
    return std::tuple{Field{"layers", &CoatedPlane::layers, true}, Field{"base", &CoatedPlane::base}};
  }
};

/// @brief A groove, dish, race or drum: a surface that is curved across the path, along it, or both.
///
/// Radii of curvature are positive for a concave and negative for a convex surface. A positive radius is at least 1.02
/// times that of the rolling body in the same direction. The layers and the base are treated as flat; the error is of
/// the order of their thickness divided by the radii.
struct Groove {
  std::optional<double> radius;       ///< across the path [m]; none: straight, as under rollers
  std::optional<double> path_radius;  ///< along the path, in its plane [m], for a dish or the race of a bearing; none:
                                      ///< straight
  CoatedPlane surface;                ///< layers and base; rigid without both

  static constexpr auto fields() {
    return std::tuple{Field{"radius", &Groove::radius}, Field{"path_radius", &Groove::path_radius},
                      Field{"surface", &Groove::surface}};
  }
};

/// @return total thickness of all layers [m]
[[nodiscard]] double coating_thickness(const CoatedPlane& plane);

/// @return whether the plane is rigid
[[nodiscard]] bool is_rigid(const CoatedPlane& plane);
/// @return whether the groove is rigid
[[nodiscard]] bool is_rigid(const Groove& groove);

/// @brief Check a plane, its layers and its base.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const CoatedPlane& plane);

/// @brief Check a groove. Whether a body fits into it is checked together with the body.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const Groove& groove);

}  // namespace viscoroll
