/// @file
/// @brief Load, speed, friction and drive of a rolling body.
#pragma once

#include "viscoroll/drive.hpp"

namespace viscoroll {

/// @brief Load, speed, friction and drive of a rolling body.
struct LoadCase {
  double load = 0.0;           ///< normal load P [N], > 0; for rollers per unit length [N/m]
  double angular_speed = 0.0;  ///< Omega [rad/s], > 0
  double friction = 0.0;       ///< Coulomb's coefficient mu between the bodies [-], in [0, 4]; infinite: full stick
  Drive drive;                 ///< without friction, a force of 0 or a creepage
};

}  // namespace viscoroll
