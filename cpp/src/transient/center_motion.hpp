/// @file
/// @brief Motion of the center while nodes stick and slip: docs/theory/transient-friction.md.
#pragma once

#include "surface/surface_operator.hpp"
#include "transient/step_end.hpp"
#include "transient/viscoelastic_pair.hpp"

namespace viscoroll::detail {

/// @brief Condition for the displacement of the center in a step: force * (forward force on the center that balances
/// given forces) + torque * (moment about the center, divided by the radius) + displacement * (displacement of the
/// center - coasted) = value.
struct CenterCondition {
  double force = 1.0;
  double torque = 0.0;
  double displacement = 0.0;
  double value = 0.0;
  /// Displacement of the center without forces [m]. In a short step, the forces of a heavy center change it by less
  /// than its round-off, so that it must not enter the balance of forces.
  double coasted = 0.0;
};

/// @brief Same condition for nodal forces F: sum of force_coefficients F + displacement * (displacement of the center -
/// coasted) = value.
struct CenterRow {
  VectorField force_coefficients;
  double displacement;
  double value;
};

/// @brief Condition for the displacement of the center in a step. A center without mass moves so that the forces
/// balance. A center with mass follows the method of J. Chung and G. M. Hulbert, J. Appl. Mech. 60 (1993) 371-375, at
/// spectral radius 0: it is exact under a constant force, and oscillations faster than the steps disappear after two
/// steps. The trapezoidal rule would ring.
/// @param[in] pair force on the center or moment about it, and its mass
/// @param[in] now position and speed of the center
/// @param[in] duration of the step [s], 0 for a jump
/// @param[in] end end of the step
[[nodiscard]] CenterCondition center_condition(const ViscoelasticPair& pair, const RollingInstant& now, double duration,
                                               const StepEnd& end);

/// @brief Move the center by a step.
/// @param[in] mass mass that moves with the center [kg]
/// @param[in] duration of the step [s]
/// @param[in] displacement displacement of the center in the step [m]
/// @param[in,out] acceleration of the center in the time integration [m/s^2]
/// @param[in,out] now displacement and speed of the center
void move_center(double mass, double duration, double displacement, double& acceleration, RollingInstant& now);

}  // namespace viscoroll::detail
