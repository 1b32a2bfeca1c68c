/// @file
/// @brief Drives: a condition on force, torque or speed. It is the equation of the system that determines the creepage.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "contact/moment_arms.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Contact forces between two bodies, and the geometry that their resultants depend on.
struct ContactState {
  const SurfaceOperator& surface;
  const MomentArms& arms;
  const VectorField& force;  ///< [N]
  VectorField displacement;  ///< displacement of the rolling body alone [m]
};

/// @brief Force with which pressure pushes the rolling body back along the deformed surface of the counterbody,
/// linearized.
struct SlopeForce {
  double force;  ///< [N]
  /// Derivative of the slope force with respect to the nodal forces [-], without the part of
  /// `SurfaceOperator::slope_force`, which is kept constant; may have no rows.
  VectorField derivative;
};

/// @brief Sum of `SurfaceOperator::slope_force` and the force due to the slope of the undeformed surface.
/// Under a rigid body it is the moment of the pressure divided by the radius: the pressure on a sphere has no moment
/// about its center.
[[nodiscard]] SlopeForce slope_force(const ContactState& state);

/// @brief Moment of the contact forces about the center of the rolling body, at displaced points.
/// It is the sum of (y + u_y) F_x - (x + pressure_work_factor u_x) F_y, where u is the displacement of the rolling body
/// alone, minus the radius times the slope force.
/// @param[in] state state of the contact
/// @param[in] pressure_work_factor 0 if pressure does no work along the plane, else 1
/// @return moment [N m]
[[nodiscard]] double moment_about_center(const ContactState& state, double pressure_work_factor);

/// @brief Linear condition on nodal forces F, displacements u and creepage c, in the form of a force [N]:
/// sum of force_coefficients F + sum of displacement_coefficients u + creepage_coefficient c = value.
struct DriveRow {
  VectorField force_coefficients;
  VectorField displacement_coefficients;  ///< no rows if the condition does not depend on displacements
  double creepage_coefficient;
  double value;

  /// @return left side of the condition
  [[nodiscard]] double of(const VectorField& force, const VectorField& displacement, double creepage) const;
};

/// @brief Condition that drives a rolling body.
class DriveCondition {
 public:
  virtual ~DriveCondition() = default;

  /// @brief Linearize the condition at a state; the row is exact there.
  /// @param[in] state state of the contact
  /// @param[in] creepage_force force that represents a creepage of 1 [N]
  [[nodiscard]] virtual DriveRow row(const ContactState& state, double creepage_force) const = 0;

  /// @return the creepage if the drive prescribes it
  [[nodiscard]] virtual std::optional<double> given_creepage() const { return std::nullopt; }
};

/// @brief Given force on the center, positive forward, balanced by the contact forces and the slope force.
class GivenForce : public DriveCondition {
 public:
  explicit GivenForce(double force) : force_(force) {}
  [[nodiscard]] DriveRow row(const ContactState& state, double creepage_force) const override;

 private:
  double force_;
};

/// @brief Given moment of the contact forces about the center, at displaced points.
class GivenMoment : public DriveCondition {
 public:
  /// @param[in] moment moment [N m]
  /// @param[in] pressure_work_factor same as in `moment_about_center`
  GivenMoment(double moment, double pressure_work_factor)
      : moment_(moment), pressure_work_factor_(pressure_work_factor) {}
  [[nodiscard]] DriveRow row(const ContactState& state, double creepage_force) const override;

 private:
  [[nodiscard]] DriveRow row_of_pair(const ContactState& state, double arm) const;

  double moment_;
  double pressure_work_factor_;
};

/// @brief Given creepage: the excess of the speed of the center over that of the undeformed surface, relative to the
/// latter.
class GivenCreepage : public DriveCondition {
 public:
  explicit GivenCreepage(double creepage) : creepage_(creepage) {}
  [[nodiscard]] DriveRow row(const ContactState& state, double creepage_force) const override;
  [[nodiscard]] std::optional<double> given_creepage() const override { return creepage_; }

 private:
  double creepage_;
};

}  // namespace viscoroll::detail
