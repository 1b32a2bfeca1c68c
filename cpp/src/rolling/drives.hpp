/// @file
/// @brief Functions of the drives that a user can give. A kind of drive is its struct in the public header and a block
/// in drives.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "contact/drive.hpp"
#include "rolling/body.hpp"
#include "viscoroll/drive.hpp"
#include "viscoroll/load_case.hpp"

namespace viscoroll::detail {

/// @brief Quantities that a drive prescribes: the force on the center, the torque or the creepage; and lateral creepage
/// and spin, which a guide imposes. The solver finds the others.
struct GivenMotion {
  std::optional<double> force;     ///< Q [N]
  std::optional<double> torque;    ///< T [N m]
  std::optional<double> creepage;  ///< V_s / (Omega r_o) - 1 [-]
  double lateral_creepage = 0.0;   ///< [-]
  double spin = 0.0;               ///< [1/m]
};

/// @return the quantities that a drive prescribes
[[nodiscard]] GivenMotion given_motion(const LoadCase& load_case);

/// @brief Parameter and unit in which messages report the force or torque that a drive prescribes.
struct DriveReport {
  std::string_view parameter;  ///< for example "drive.torque"
  double factor;               ///< value of the parameter divided by the force or torque
  std::string_view unit;
};

/// @return the report for the drive of a load case
[[nodiscard]] DriveReport drive_report(const LoadCase& load_case, const RoundBody& body);

/// @brief Condition of a drive, which is a row of the system.
/// @param[in] load_case load case, whose drive determines the speed of the center
/// @param[in] pressure_work_factor same as in `moment_about_center`
[[nodiscard]] std::shared_ptr<const DriveCondition> condition_of(const LoadCase& load_case,
                                                                 double pressure_work_factor);

/// @throws InvalidInput for numbers that are not finite, and for a force or torque that friction cannot
/// balance
void validate_drive(const LoadCase& load_case, const RoundBody& body);

}  // namespace viscoroll::detail
