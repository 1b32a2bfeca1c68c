/// @file
/// @brief A wheel: a rigid hub covered by bonded viscoelastic layers, with a width, a crown and side faces.
#pragma once

#include <limits>
#include <vector>

#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief What the hub of a crowned wheel looks like under the tread, and with it how thick the tread is at its sides.
enum class Hub {
  straight,  ///< a cylinder: the tread is thinner at its sides
  crowned,   ///< it follows the crown: the layers are as thick everywhere
};

/// @brief What a tread ends in.
enum class Sides {
  free,     ///< faces at half the width, which bulge
  endless,  ///< none: the tread goes on, but bears pressure within the width alone
};

/// @brief Layers bonded to one another and to a rigid hub. Without a hub a wheel has no finite approach (see
/// docs/theory/wheels.md).
struct CoatedWheel {
  double core_radius = 0.0;   ///< of the hub, in the middle of its width [m], > 0
  std::vector<Layer> layers;  ///< from the hub outwards, as thick as they are in the middle; none: a rigid wheel
  double width = 0.0;         ///< from face to face [m], > 0, at most 1000 times the outer radius
  /// Radius of the tread's profile across the path [m], from half the width to 1e6 times the outer radius; infinite
  /// where the tread is flat.
  double crown_radius = std::numeric_limits<double>::infinity();
  Hub hub = Hub::straight;
  Sides sides = Sides::free;
};

/// @return outer radius in the middle, r_o [m]
[[nodiscard]] double outer_radius(const CoatedWheel& wheel);

/// @return thickness of all layers together, in the middle [m]
[[nodiscard]] double coating_thickness(const CoatedWheel& wheel);

/// @return how far the crown lies below its middle at a distance from it [m]
/// @param[in] wheel its crown
/// @param[in] z along the axis [m], at most half the width
[[nodiscard]] double crown_drop(const CoatedWheel& wheel, double z);

/// @brief Lowest rolling speed at which a wave of some order, straight along or oblique, keeps up with the surface.
/// @param[in] wheel hub and layers; sides do not count
/// @param[in] highest_frequency stands for the short-time limit of a `CustomModulus` [rad/s]
/// @return angular speed [rad/s]; infinite without inertia
[[nodiscard]] double critical_speed(const CoatedWheel& wheel, double highest_frequency = 1e9);

/// @brief Check a wheel and its layers.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const CoatedWheel& wheel);

}  // namespace viscoroll
