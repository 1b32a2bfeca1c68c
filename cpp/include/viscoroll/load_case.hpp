/// @file
/// @brief What presses a rolling body on another, turns it and drives it.
#pragma once

#include "viscoroll/drive.hpp"

namespace viscoroll {

/// @brief What presses the rolling body and turns it.
struct LoadCase {
  double load = 0.0;           ///< P, force on what it rolls on [N], of a roller per length, > 0
  double angular_speed = 0.0;  ///< Omega [rad/s], > 0
  double friction = 0.0;       ///< Coulomb's coefficient mu between the bodies [-], in [0, 4]; infinite: full stick
  Drive drive;                 ///< without friction, a force of 0 or a creepage
};

}  // namespace viscoroll
