/// @file
/// @brief Drive of a rolling body: a given force, torque, power or creepage.
#pragma once

#include <tuple>
#include <variant>

#include "viscoroll/fields.hpp"

namespace viscoroll {

/// @brief A given horizontal force Q on the center. If it is 0, a torque alone drives the body.
struct DriveForce {
  double force = 0.0;  ///< Q, positive forward [N], |Q| < friction * load

  static constexpr auto fields() { return std::tuple{Field{"force", &DriveForce::force}}; }
};

/// @brief A given driving torque T about the center. If it is 0, the body is towed.
struct DriveTorque {
  double torque = 0.0;  ///< T, positive if it increases the angular speed [N m]; requires friction

  static constexpr auto fields() { return std::tuple{Field{"torque", &DriveTorque::torque}}; }
};

/// @brief A given driving power at the axle, T Omega. A negative power brakes the body.
struct DrivePower {
  double power = 0.0;  ///< T Omega [W]; requires friction

  static constexpr auto fields() { return std::tuple{Field{"power", &DrivePower::power}}; }
};

/// @brief A given speed of the center, as creepages, and a given spin.
struct DriveCreepage {
  double creepage = 0.0;          ///< V_s / (Omega r_o) - 1 [-], positive forward
  double lateral_creepage = 0.0;  ///< sideways speed of the center divided by Omega r_o [-]
  double spin = 0.0;  ///< angular speed about the downward axis through the contact, divided by Omega r_o [1/m]

  static constexpr auto fields() {
    return std::tuple{Field{"creepage", &DriveCreepage::creepage},
                      Field{"lateral_creepage", &DriveCreepage::lateral_creepage, true},
                      Field{"spin", &DriveCreepage::spin, true}};
  }
};

/// @brief Condition that determines the linear speed V_s. The first field of each struct is the prescribed quantity.
using Drive = std::variant<DriveForce, DriveTorque, DrivePower, DriveCreepage>;

}  // namespace viscoroll
