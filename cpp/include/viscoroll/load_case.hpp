/// @file
/// @brief Load or penetration, speed, friction and drive of a rolling body.
#pragma once

#include <optional>

#include "viscoroll/drive.hpp"

namespace viscoroll {

/// @brief Load or penetration, speed, friction and drive of a rolling body. Exactly one of load and penetration is
/// given; the other one is a result.
struct LoadCase {
  std::optional<double> load = {};  ///< normal load P [N], > 0; for rollers per unit length [N/m]
  /// Penetration r_o - H [m], the same quantity as `Result::penetration`: radius at rest minus height of the center. It
  /// is larger than minus the centrifugal displacement and smaller than the thickness of the layers.
  std::optional<double> penetration = {};
  double angular_speed = 0.0;  ///< Omega [rad/s], > 0
  double friction = 0.0;       ///< Coulomb's coefficient mu between the bodies [-], in [0, 4]; infinite: full stick
  Drive drive;                 ///< without friction, a force of 0 or a creepage
};

}  // namespace viscoroll
