#include "contact/moment_arms.hpp"

namespace viscoroll::detail {

MomentArms added_arms(const VectorField& displacement, double pressure_work_factor) {
  return {.x = pressure_work_factor * displacement.col(kForward), .y = displacement.col(kDown), .radius = 0.0};
}

MomentArms displaced(MomentArms arms, const VectorField& displacement, double pressure_work_factor) {
  arms.x += pressure_work_factor * displacement.col(kForward);
  arms.y += displacement.col(kDown);
  return arms;
}

VectorField moment_per_force(const MomentArms& arms) {
  VectorField row = VectorField::Zero(arms.x.size(), 3);
  row.col(kForward) = arms.y;
  row.col(kDown) = -arms.x;
  return row;
}

double moment(const MomentArms& arms, const VectorField& force) {
  return (arms.y * force.col(kForward) - arms.x * force.col(kDown)).sum();
}

}  // namespace viscoroll::detail
