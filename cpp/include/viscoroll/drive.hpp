/// @file
/// @brief How a rolling body is driven.
#pragma once

#include <variant>

namespace viscoroll {

/// @brief A given horizontal force Q on the center, forward: 0 for a sphere that a torque alone drives.
struct DriveForce {
  double force = 0.0;  ///< Q [N], |Q| < friction * load
};

/// @brief A given driving torque T: 0 for a sphere that is towed.
struct DriveTorque {
  double torque = 0.0;  ///< T [N m]
};

/// @brief A given speed.
struct DriveCreepage {
  double creepage = 0.0;          ///< V_s / (Omega r_o) - 1 [-], forward
  double lateral_creepage = 0.0;  ///< sideways speed of the center, per Omega r_o [-]
  double spin = 0.0;              ///< turning about the downward axis through the contact, per Omega r_o [1/m]
};

/// @brief What closes the system for the linear speed V_s.
using Drive = std::variant<DriveForce, DriveTorque, DriveCreepage>;

}  // namespace viscoroll
