/// @file
/// @brief A roller: a rigid core covered by bonded viscoelastic layers, in line contact.
#pragma once

#include <vector>

#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief Layers bonded to one another and to a rigid core, as long as one likes: plane strain, all forces and powers
/// per length. Without a core a line load would have no finite compliance (docs/theory/rollers.md).
struct CoatedCylinder {
  double core_radius = 0.0;   ///< [m], > 0
  std::vector<Layer> layers;  ///< from the core outwards; none: a rigid cylinder
};

/// @return outer radius r_o [m]
[[nodiscard]] double outer_radius(const CoatedCylinder& cylinder);

/// @return thickness of all layers together [m]
[[nodiscard]] double coating_thickness(const CoatedCylinder& cylinder);

/// @brief Check a cylinder and its layers.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const CoatedCylinder& cylinder);

/// @brief Lowest rolling speed at which a wave of some order keeps up with the surface.
/// @param[in] cylinder core and layers
/// @param[in] highest_frequency stands for the short-time limit of a `CustomModulus` [rad/s]
/// @return angular speed [rad/s]; infinite without inertia
[[nodiscard]] double critical_speed(const CoatedCylinder& cylinder, double highest_frequency = 1e9);

}  // namespace viscoroll
