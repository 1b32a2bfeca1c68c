/// @file
/// @brief All that is asked of the drives that a user gives: a kind of drive is its struct in the public header and a
/// paragraph of drives.cpp.
#pragma once

#include <memory>
#include <optional>

#include "contact/drive.hpp"
#include "rolling/body.hpp"
#include "viscoroll/drive.hpp"
#include "viscoroll/load_case.hpp"

namespace viscoroll::detail {

/// @brief What of the motion of the center, and of what moves it, a drive gives; the rest is found.
struct GivenMotion {
  std::optional<double> force;     ///< Q [N]
  std::optional<double> torque;    ///< T [N m]
  std::optional<double> creepage;  ///< V_s / (Omega r_o) - 1 [-]
  double lateral_creepage = 0.0;   ///< [-]
  double spin = 0.0;               ///< [1/m]
};

[[nodiscard]] GivenMotion given_motion(const Drive& drive);

/// @param[in] drive what closes the equations for the speed
/// @param[in] pressure_share as for `moment_about_center`
/// @return its condition, a row of the system
[[nodiscard]] std::shared_ptr<const DriveCondition> condition_of(const Drive& drive, double pressure_share);

/// @throws std::invalid_argument for numbers that are not finite, and those that no friction can hold
void validate_drive(const LoadCase& load_case, const RoundBody& body);

}  // namespace viscoroll::detail
