/// @file
/// @brief What closes the equations of rolling for the speed: one row of the system each.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "contact/lever_arms.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief A condition on forces F, displacements u and speed ratio s, as a force [N]:
/// sum of on_force F + sum of on_displacement u + on_speed s = value.
struct DriveRow {
  VectorField on_force;
  VectorField on_displacement;  ///< no rows where displacements do not matter
  double on_speed;
  double value;

  /// @return left side
  [[nodiscard]] double of(const VectorField& force, const VectorField& displacement, double speed_ratio) const;
};

/// @brief How a rolling body is driven.
class Drive {
 public:
  virtual ~Drive() = default;

  /// @brief The condition linearized at a state, where it is exact.
  /// @param[in] arms undisplaced
  /// @param[in] force,displacement the state
  /// @param[in] speed_force force that a unit of the speed ratio is to count for [N]
  [[nodiscard]] virtual DriveRow row(const LeverArms& arms, const VectorField& force, const VectorField& displacement,
                                     double speed_force) const = 0;

  /// @return the speed ratio, where it is what the drive gives
  [[nodiscard]] virtual std::optional<double> given_speed_ratio() const { return std::nullopt; }
};

/// @brief A given force on the center, forward; the contact forces balance it.
class GivenForce : public Drive {
 public:
  explicit GivenForce(double force) : force_(force) {}
  [[nodiscard]] DriveRow row(const LeverArms& arms, const VectorField& force, const VectorField& displacement,
                             double speed_force) const override;

 private:
  double force_;
};

/// @brief A given moment of the contact forces about the center, at displaced points.
class GivenMoment : public Drive {
 public:
  /// @param[in] moment [N m]
  /// @param[in] pressure_share as for `added_arms`
  GivenMoment(double moment, double pressure_share) : moment_(moment), pressure_share_(pressure_share) {}
  [[nodiscard]] DriveRow row(const LeverArms& arms, const VectorField& force, const VectorField& displacement,
                             double speed_force) const override;

 private:
  double moment_;
  double pressure_share_;
};

/// @brief A given ratio of the speed to that of the undeformed surface.
class GivenSpeed : public Drive {
 public:
  explicit GivenSpeed(double ratio) : ratio_(ratio) {}
  [[nodiscard]] DriveRow row(const LeverArms& arms, const VectorField& force, const VectorField& displacement,
                             double speed_force) const override;
  [[nodiscard]] std::optional<double> given_speed_ratio() const override { return ratio_; }

 private:
  double ratio_;
};

}  // namespace viscoroll::detail
