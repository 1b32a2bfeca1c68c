/// @file
/// @brief Center of the rolling body: forces and moments that the contact exerts on it
/// (docs/theory/planes-and-pairs.md), and its motion in a step while nodes stick and slip
/// (docs/theory/transient-friction.md).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "surface/surface_operator.hpp"
#include "transient/contact_place.hpp"
#include "transient/elastic_contact.hpp"
#include "transient/time_step.hpp"
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

/// @brief Positions at which forces act at an instant.
struct ActingPlaces {
  const ViscoelasticPair& pair;
  const ContactPlace& place;
  /// Displacements of each body in the window, by its components, as in `RowMemory`
  std::span<const HalfField> deformed;
};

/// @return coefficients of Q, the force on the center that balances the nodal forces [-]
[[nodiscard]] VectorField force_on_center(const ActingPlaces& at);

/// @return coefficients of T, the moment of the nodal forces about the center [m]
[[nodiscard]] VectorField moment_about_center(const ActingPlaces& at);

/// @brief Force on the displacement of the center that has the power of Q and of the moment that turns the counterbody.
/// @param[in] at positions of the forces
/// @param[in] penetration of the center [m]
/// @return coefficients of the nodal forces [-]
[[nodiscard]] VectorField force_along_track(const ActingPlaces& at, double penetration);

/// @return slopes of the counterbody's own displacement in the direction in which material passes, forward, down and
/// sideways, at every node [-]; no rows if the counterbody is rigid
[[nodiscard]] VectorField counterbody_slopes(const ActingPlaces& at);

/// @return the condition on the center for forces on half of the nodes, at displaced nodes
[[nodiscard]] CenterRow center_row(const ActingPlaces& at, const CenterCondition& condition);

/// @return whether the condition on the center depends on displacements
[[nodiscard]] bool depends_on_displacements(const ViscoelasticPair& pair, const CenterCondition& condition);

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

/// @brief State of an axle between steps, besides its speed.
struct AxleState {
  /// Upward acceleration in the time integration [m/s^2]
  double acceleration = 0.0;
  double rest = 0.0;  ///< penetration at which the spring exerts no force [m]
};

/// @return period in which an axle with mass vibrates on the contact and its spring [s]
[[nodiscard]] double vibration_period(const Axle& axle, double contact_stiffness);

/// @brief Condition for load and penetration at the end of a step of an axle with mass, spring and damper.
///
/// The time integration is that of W. L. Wood, M. Bossak and O. C. Zienkiewicz, Int. J. Numer. Methods Eng. 15 (1980)
/// 1562-1566. If the steps resolve the vibration of a mass, it is the trapezoidal rule, which conserves energy. Else it
/// is the method of a center with mass (`center_condition`), in which such vibrations disappear after two steps.
/// @param[in] axle mass, spring and damper
/// @param[in] now penetration and speed at the start of the step
/// @param[in] state acceleration in the time integration, and rest of the spring
/// @param[in] step its duration, 0 for a jump, in which a mass or a damper does not move, and stiffness of the contact
/// @param[in] force external force at the end of the step [N]
[[nodiscard]] ApproachCondition axle_condition(const Axle& axle, const RollingInstant& now, const AxleState& state,
                                               const PairStep& step, double force);

/// @return the same condition for forces multiplied by a factor
[[nodiscard]] ApproachCondition scaled(const ApproachCondition& condition, double factor);

/// @brief Take speed, acceleration, energy and losses of the axle at the end of a step.
/// @param[in] axle mass, spring and damper; without them, the speed is the mean over the step
/// @param[in] step same as in `axle_condition`
/// @param[in] before instant at the start of the step
/// @param[in,out] state acceleration in the time integration
/// @param[in,out] now instant at the end of the step, with its penetration and forces
void move_axle(const std::optional<Axle>& axle, const PairStep& step, const RollingInstant& before, AxleState& state,
               RollingInstant& now);

/// @brief Move the center by a step.
/// @param[in] mass mass that moves with the center [kg]
/// @param[in] duration of the step [s]
/// @param[in] displacement displacement of the center in the step [m]
/// @param[in,out] acceleration of the center in the time integration [m/s^2]
/// @param[in,out] now displacement and speed of the center
void move_center(double mass, double duration, double displacement, double& acceleration, RollingInstant& now);

}  // namespace viscoroll::detail
