/// @file
/// @brief What closes the equations of rolling for the creepage: one row of the system each.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "contact/lever_arms.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Forces between two bodies, and what follows from them.
struct ContactState {
  const SurfaceOperator& surface;
  const LeverArms& arms;
  const VectorField& force;  ///< [N]
  VectorField displacement;  ///< of what rolls by itself [m]
};

/// @brief The force with which pressure pushes what rolls back, along the deformed surface that it stands on,
/// linearized.
struct Pushback {
  double force;  ///< [N]
  VectorField
      on_force;  ///< its derivative [-], but for `SurfaceOperator::pushback`, which is taken as it is; or no rows
};

/// @brief The sum of `SurfaceOperator::pushback` and of what the slope of the undeformed surface makes of the pressure.
/// Under a rigid body the moment of the pressure per radius, for there the pressure itself has no moment: it stands on
/// a sphere.
[[nodiscard]] Pushback pushback(const ContactState& state);

/// @brief Moment of the contact forces about the center of what rolls, at displaced points:
/// sum of (y + u_y) F_x - (x + share u_x) F_y, u its own displacement, less radius times pushback.
/// @param[in] state of the contact
/// @param[in] pressure_share 0 where pressure does no work along the plane, else 1
/// @return [N m]
[[nodiscard]] double moment_about_center(const ContactState& state, double pressure_share);

/// @brief A condition on forces F, displacements u and creepage c, as a force [N]:
/// sum of on_force F + sum of on_displacement u + on_creepage c = value.
struct DriveRow {
  VectorField on_force;
  VectorField on_displacement;  ///< no rows where displacements do not matter
  double on_creepage;
  double value;

  /// @return left side
  [[nodiscard]] double of(const VectorField& force, const VectorField& displacement, double creepage) const;
};

/// @brief How a rolling body is driven, as the equations have it.
class DriveCondition {
 public:
  virtual ~DriveCondition() = default;

  /// @brief The condition linearized at a state, where it is exact.
  /// @param[in] state where
  /// @param[in] creepage_force force that a creepage of 1 is to count for [N]
  [[nodiscard]] virtual DriveRow row(const ContactState& state, double creepage_force) const = 0;

  /// @return the creepage, where it is what the drive gives
  [[nodiscard]] virtual std::optional<double> given_creepage() const { return std::nullopt; }
};

/// @brief A given force on the center, forward; the contact forces balance it, the pushback among them.
class GivenForce : public DriveCondition {
 public:
  explicit GivenForce(double force) : force_(force) {}
  [[nodiscard]] DriveRow row(const ContactState& state, double creepage_force) const override;

 private:
  double force_;
};

/// @brief A given moment of the contact forces about the center, at displaced points.
class GivenMoment : public DriveCondition {
 public:
  /// @param[in] moment [N m]
  /// @param[in] pressure_share as for `moment_about_center`
  GivenMoment(double moment, double pressure_share) : moment_(moment), pressure_share_(pressure_share) {}
  [[nodiscard]] DriveRow row(const ContactState& state, double creepage_force) const override;

 private:
  [[nodiscard]] DriveRow row_of_pair(const ContactState& state, double arm) const;

  double moment_;
  double pressure_share_;
};

/// @brief A given excess of the speed over that of the undeformed surface, relative to it.
class GivenCreepage : public DriveCondition {
 public:
  explicit GivenCreepage(double creepage) : creepage_(creepage) {}
  [[nodiscard]] DriveRow row(const ContactState& state, double creepage_force) const override;
  [[nodiscard]] std::optional<double> given_creepage() const override { return creepage_; }

 private:
  double creepage_;
};

}  // namespace viscoroll::detail
