/// @file
/// @brief A wheel: a rigid hub with bonded viscoelastic layers, a width, a crown and side faces.
#pragma once

#include <limits>
#include <tuple>
#include <vector>

#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief Shape of the hub under a crowned tread. It determines the thickness of the tread towards its faces.
enum class Hub {
  straight,  ///< a cylinder: the tread is thinner towards its faces
  crowned,   ///< the hub follows the crown: the thickness of the layers is the same everywhere
};

/// @brief Lateral ends of the tread.
enum class Sides {
  free,       ///< the tread ends at faces at half the width, which can bulge
  unbounded,  ///< the tread has no faces and continues to infinity, but supports pressure only within the width
};

/// @brief Layers that are bonded to one another and to a rigid hub.
///
/// A hub is required, since the compliance of a wheel without one is infinite (docs/theory/wheels.md).
struct CoatedWheel {
  double core_radius = 0.0;   ///< radius of the hub in the middle of its width [m], > 0
  std::vector<Layer> layers;  ///< from the hub outwards, with the thickness in the middle; empty: a rigid wheel
  double width = 0.0;         ///< distance between the faces [m], > 0, at most 1000 times the outer radius
  /// Radius of the tread's profile across the path [m], from half the width to 1e6 times the outer radius; infinite for
  /// a flat tread.
  double crown_radius = std::numeric_limits<double>::infinity();
  Hub hub = Hub::straight;    ///< shape of the hub
  Sides sides = Sides::free;  ///< lateral ends of the tread

  static constexpr auto fields() {
    return std::tuple{Field{"core_radius", &CoatedWheel::core_radius},
                      Field{"layers", &CoatedWheel::layers, true},
                      Field{"width", &CoatedWheel::width},
                      Field{"crown_radius", &CoatedWheel::crown_radius, true},
                      Field{"hub", &CoatedWheel::hub, true},
                      Field{"sides", &CoatedWheel::sides, true}};
  }
};

/// @return outer radius in the middle of the width, r_o [m]
[[nodiscard]] double outer_radius(const CoatedWheel& wheel);

/// @return total thickness of all layers in the middle of the width [m]
[[nodiscard]] double coating_thickness(const CoatedWheel& wheel);

/// @brief Depth of the crown's surface below its highest point.
/// @param[in] wheel wheel with or without a crown
/// @param[in] z distance from the middle along the axis [m], at most half the width
/// @return depth [m]
[[nodiscard]] double crown_drop(const CoatedWheel& wheel, double z);

/// @brief Lowest rolling speed at which a surface wave, along the path or oblique, keeps up with the contact
/// (docs/theory/inertia.md).
/// @param[in] wheel hub and layers; the sides have no effect
/// @param[in] highest_frequency angular frequency at which a `CustomModulus` is evaluated in place of its short-time
/// limit [rad/s], > 0
/// @return critical angular speed Omega [rad/s]; infinite without inertia, or if no short-time modulus is finite
/// @throws InvalidInput for invalid input
[[nodiscard]] double critical_speed(const CoatedWheel& wheel, double highest_frequency = 1e9);

/// @brief Check a wheel and its layers.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const CoatedWheel& wheel);

}  // namespace viscoroll
