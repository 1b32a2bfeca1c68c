#include "transient/center_motion.hpp"

namespace viscoroll::detail {

CenterCondition center_condition(const ViscoelasticPair& pair, const RollingInstant& now, double duration,
                                 const StepEnd& end) {
  if (end.center_displacement)
    return {
        .force = 0.0, .torque = 0.0, .displacement = 1.0, .value = *end.center_displacement - now.center_displacement};
  if (pair.driving_torque) {
    return {.force = 0.0, .torque = 1.0, .displacement = 0.0, .value = *pair.driving_torque / pair.nodes.grid.radius};
  }
  const double mass = pair.mass;
  if (mass == 0.0) return {.force = 1.0, .torque = 0.0, .displacement = 0.0, .value = -pair.driving_force};
  if (duration == 0.0) return {.force = 0.0, .torque = 0.0, .displacement = 1.0, .value = 0.0};
  return {.force = 1.0,
          .torque = 0.0,
          .displacement = -2.0 * mass / (duration * duration),
          .value = -pair.driving_force,
          .coasted = now.center_speed * duration};
}

void move_center(double mass, double duration, double displacement, double& acceleration, RollingInstant& now) {
  now.center_displacement += displacement;
  if (duration == 0.0) return;
  const double mean_speed = displacement / duration;
  const double before = acceleration;
  if (mass == 0.0) {
    now.center_speed = mean_speed;
    return;
  }
  acceleration = (mean_speed - now.center_speed) / duration + 0.5 * before;
  now.center_speed += duration * (1.5 * acceleration - 0.5 * before);
}

}  // namespace viscoroll::detail
