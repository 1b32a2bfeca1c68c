#include "rolling/drives.hpp"

#include <cmath>
#include <string>

#include "base/validate.hpp"

namespace viscoroll::detail {
namespace {

using std::string;
using Condition = std::shared_ptr<const DriveCondition>;

GivenMotion given(const DriveForce& drive) { return {.force = drive.force, .torque = {}, .creepage = {}}; }

Condition condition(const DriveForce& drive, double /*pressure_work_factor*/) {
  return std::make_shared<GivenForce>(drive.force);
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

GivenMotion given(const DriveTorque& drive) { return {.force = {}, .torque = drive.torque, .creepage = {}}; }

Condition condition(const DriveTorque& drive, double pressure_work_factor) {
  return std::make_shared<GivenMoment>(drive.torque, pressure_work_factor);
}

void validate(const DriveTorque& drive, const LoadCase& load_case, const RoundBody& body) {
  require_finite("drive.torque", drive.torque);
  if (load_case.friction > 0.0) return;
  reject("drive.torque", "left out without friction, where the torque follows from the pressure",
         text(drive.torque) + " " + string(body.form().torque_unit));
}

GivenMotion given(const DriveCreepage& drive) {
  return {.force = {},
          .torque = {},
          .creepage = drive.creepage,
          .lateral_creepage = drive.lateral_creepage,
          .spin = drive.spin};
}

Condition condition(const DriveCreepage& drive, double /*pressure_work_factor*/) {
  return std::make_shared<GivenCreepage>(drive.creepage);
}

void validate(const DriveCreepage& drive, const LoadCase& /*load_case*/, const RoundBody& /*body*/) {
  require_finite("drive.creepage", drive.creepage);
  require_finite("drive.lateral_creepage", drive.lateral_creepage);
  require_finite("drive.spin", drive.spin);
}

}  // namespace

GivenMotion given_motion(const Drive& drive) {
  return std::visit([](const auto& kind) { return given(kind); }, drive);
}

std::shared_ptr<const DriveCondition> condition_of(const Drive& drive, double pressure_work_factor) {
  return std::visit([pressure_work_factor](const auto& kind) { return condition(kind, pressure_work_factor); }, drive);
}

void validate_drive(const LoadCase& load_case, const RoundBody& body) {
  std::visit([&](const auto& kind) { validate(kind, load_case, body); }, load_case.drive);
}

}  // namespace viscoroll::detail
