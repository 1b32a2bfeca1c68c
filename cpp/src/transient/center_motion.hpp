/// @file
/// @brief How the center goes while nodes stick and slip below it: docs/theory/transient-friction.md.
#pragma once

#include "surface/surface_operator.hpp"
#include "transient/creeping_pair.hpp"
#include "transient/step_end.hpp"

namespace viscoroll::detail {

/// @brief What decides how far the center comes in a step: force * (the forces on it that balance a given one, forward)
/// + torque * (their moment about it per radius) + way * (its way - coasted) = value.
struct CenterCondition {
  double force = 1.0;
  double torque = 0.0;
  double way = 0.0;
  double value = 0.0;
  /// Distance that the center covers without forces [m]. The forces of a heavy center in a short step change it by less
  /// than its round-off, so it must not enter the balance of forces.
  double coasted = 0.0;
};

/// @brief The same for forces at nodes: sum of on_force F + way * (displacement of the center - coasted) = value.
struct CenterRow {
  VectorField on_force;
  double way;
  double value;
};

/// @brief What decides how far the center comes in a step. Without mass it goes where forces balance. With it, by the
/// method of J. Chung and G. M. Hulbert, J. Appl. Mech. 60 (1993) 371-375, at spectral radius 0: exact where the force
/// is constant, and what swings faster than the steps is gone after two of them. The trapezoidal rule would ring.
/// @param[in] pair force on the center or moment about it, and its mass
/// @param[in] now where the center is, and how fast
/// @param[in] duration of the step [s], 0 for a jump
/// @param[in] end of the step
[[nodiscard]] CenterCondition center_condition(const CreepingPair& pair, const RollingInstant& now, double duration,
                                               const StepEnd& end);

/// @brief The center after a step.
/// @param[in] mass that moves with it [kg]
/// @param[in] duration of the step [s]
/// @param[in] way of the center in it [m]
/// @param[in,out] acceleration as the integration in time has it [m/s^2]
/// @param[in,out] now its way and speed
void move_center(double mass, double duration, double way, double& acceleration, RollingInstant& now);

}  // namespace viscoroll::detail
