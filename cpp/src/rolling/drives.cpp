#include "rolling/drives.hpp"

#include <cmath>
#include <string>

#include "base/validate.hpp"

namespace viscoroll::detail {
namespace {

using std::string;

GivenMotion given(const DriveForce& drive, const LoadCase& /*load_case*/) {
  return {.force = drive.force, .torque = {}, .creepage = {}};
}

DriveReport reported(const DriveForce& /*drive*/, const LoadCase& /*load_case*/, const RoundBody& body) {
  return {.parameter = "drive.force", .factor = 1.0, .unit = body.form().load_unit};
}

void validate(const DriveForce& drive, const LoadCase& load_case, const RoundBody& body) {
  require_finite("drive.force", drive.force);
  if (drive.force == 0.0 || !load_case.load) return;  // at a given penetration, the load is known only afterwards
  const double largest = load_case.friction * *load_case.load;
  if (std::abs(drive.force) < largest) return;
  const string unit = " " + string(body.form().load_unit);
  reject("drive.force",
         "smaller than friction * load = " + text(largest) + unit + " in magnitude, otherwise the " +
             string(body.name()) + " slides permanently",
         text(drive.force) + unit);
}

/// A torque, also if it follows from another quantity, needs friction.
void require_friction_for(const DriveReport& report, double value, const LoadCase& load_case) {
  require_finite(report.parameter, value);
  if (load_case.friction > 0.0) return;
  reject(report.parameter, "left out without friction, where the torque follows from the pressure",
         text(value) + " " + string(report.unit));
}

GivenMotion given(const DriveTorque& drive, const LoadCase& /*load_case*/) {
  return {.force = {}, .torque = drive.torque, .creepage = {}};
}

DriveReport reported(const DriveTorque& /*drive*/, const LoadCase& /*load_case*/, const RoundBody& body) {
  return {.parameter = "drive.torque", .factor = 1.0, .unit = body.form().torque_unit};
}

void validate(const DriveTorque& drive, const LoadCase& load_case, const RoundBody& body) {
  require_friction_for(reported(drive, load_case, body), drive.torque, load_case);
}

GivenMotion given(const DrivePower& drive, const LoadCase& load_case) {
  return {.force = {}, .torque = drive.power / load_case.angular_speed, .creepage = {}};
}

DriveReport reported(const DrivePower& /*drive*/, const LoadCase& load_case, const RoundBody& body) {
  return {.parameter = "drive.power", .factor = load_case.angular_speed, .unit = body.form().is_line() ? "W/m" : "W"};
}

void validate(const DrivePower& drive, const LoadCase& load_case, const RoundBody& body) {
  require_friction_for(reported(drive, load_case, body), drive.power, load_case);
}

GivenMotion given(const DriveCreepage& drive, const LoadCase& /*load_case*/) {
  return {.force = {},
          .torque = {},
          .creepage = drive.creepage,
          .lateral_creepage = drive.lateral_creepage,
          .spin = drive.spin};
}

DriveReport reported(const DriveCreepage& /*drive*/, const LoadCase& /*load_case*/, const RoundBody& /*body*/) {
  return {.parameter = "drive.creepage", .factor = 1.0, .unit = ""};
}

void validate(const DriveCreepage& drive, const LoadCase& /*load_case*/, const RoundBody& /*body*/) {
  require_finite("drive.creepage", drive.creepage);
  require_finite("drive.lateral_creepage", drive.lateral_creepage);
  require_finite("drive.spin", drive.spin);
}

}  // namespace

GivenMotion given_motion(const LoadCase& load_case) {
  return std::visit([&](const auto& kind) { return given(kind, load_case); }, load_case.drive);
}

DriveReport drive_report(const LoadCase& load_case, const RoundBody& body) {
  return std::visit([&](const auto& kind) { return reported(kind, load_case, body); }, load_case.drive);
}

std::shared_ptr<const DriveCondition> condition_of(const LoadCase& load_case, double pressure_work_factor) {
  const GivenMotion motion = given_motion(load_case);
  if (motion.force) return std::make_shared<GivenForce>(*motion.force);
  if (motion.torque) return std::make_shared<GivenMoment>(*motion.torque, pressure_work_factor);
  return std::make_shared<GivenCreepage>(motion.creepage.value());
}

void validate_drive(const LoadCase& load_case, const RoundBody& body) {
  std::visit([&](const auto& kind) { validate(kind, load_case, body); }, load_case.drive);
}

}  // namespace viscoroll::detail
