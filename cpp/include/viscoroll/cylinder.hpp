/// @file
/// @brief A roller: a rigid core with bonded viscoelastic layers, in line contact.
#pragma once

#include <tuple>
#include <vector>

#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief A long roller: layers that are bonded to one another and to a rigid core.
///
/// The layers are in plane strain; all forces and powers are per unit length. A core is required, since the compliance
/// of a roller without one is infinite under a line load (docs/theory/rollers.md).
struct CoatedCylinder {
  double core_radius = 0.0;   ///< radius of the core [m], > 0
  std::vector<Layer> layers;  ///< from the core outwards; empty: a rigid cylinder

  static constexpr auto fields() {
    return std::tuple{Field{"core_radius", &CoatedCylinder::core_radius},
                      Field{"layers", &CoatedCylinder::layers, true}};
  }
};

/// @return outer radius r_o [m]
[[nodiscard]] double outer_radius(const CoatedCylinder& cylinder);

/// @return total thickness of all layers [m]
[[nodiscard]] double coating_thickness(const CoatedCylinder& cylinder);

/// @brief Check a cylinder and its layers.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const CoatedCylinder& cylinder);

/// @brief Lowest rolling speed at which a surface wave keeps up with the contact (docs/theory/inertia.md).
/// @param[in] cylinder core and layers
/// @param[in] highest_frequency angular frequency at which a `CustomModulus` is evaluated in place of its short-time
/// limit [rad/s], > 0
/// @return critical angular speed Omega [rad/s]; infinite without inertia, or if no short-time modulus is finite
/// @throws InvalidInput for invalid input
[[nodiscard]] double critical_speed(const CoatedCylinder& cylinder, double highest_frequency = 1e9);

}  // namespace viscoroll
