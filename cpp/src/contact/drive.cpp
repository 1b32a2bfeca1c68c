#include "contact/drive.hpp"

#include <utility>

namespace viscoroll::detail {

Pushback pushback(const ContactState& state) {
  switch (state.surface.bodies()) {
    case Bodies::rolling:
      return {.force = 0.0, .on_force = {}};
    case Bodies::counterpart: {
      VectorField on_force = VectorField::Zero(state.force.rows(), 3);
      on_force.col(kDown) = -state.arms.x / state.arms.radius;
      return {.force = (on_force * state.force).sum(), .on_force = std::move(on_force)};
    }
    default:
      return {.force = state.surface.pushback(state.force), .on_force = {}};
  }
}

double moment_about_center(const ContactState& state, double pressure_share) {
  const auto& [surface, arms, force, displacement] = state;
  if (surface.bodies() == Bodies::rolling) return moment(displaced(arms, displacement, pressure_share), force);
  const VectorField own = surface.rolling_displacement(force);
  return moment(displaced(arms, own, pressure_share), force) - arms.radius * pushback(state).force;
}

double DriveRow::of(const VectorField& force, const VectorField& displacement, double speed_ratio) const {
  double sum = (on_force * force).sum() + on_speed * speed_ratio;
  if (on_displacement.rows() > 0) sum += (on_displacement * displacement).sum();
  return sum;
}

DriveRow GivenForce::row(const ContactState& state, double) const {
  DriveRow row{
      .on_force = VectorField::Zero(state.force.rows(), 3), .on_displacement = {}, .on_speed = 0.0, .value = -force_};
  row.on_force.col(kForward).setOnes();
  const auto [pushed_back, on_force] = pushback(state);
  row.value += pushed_back;
  if (on_force.rows() > 0) {
    row.on_force -= on_force;
    row.value -= (on_force * state.force).sum();
  }
  return row;
}

DriveRow GivenMoment::row(const ContactState& state, double) const {
  const auto& [surface, arms, force, displacement] = state;
  const double arm = arms.y.maxCoeff();  // any length turns the condition into one on a force
  if (surface.bodies() != Bodies::rolling) return row_of_pair(state, arm);
  const LeverArms at = displaced(arms, displacement, pressure_share_);
  DriveRow row{.on_force = VectorField::Zero(force.rows(), 3),
               .on_displacement = VectorField::Zero(force.rows(), 3),
               .on_speed = 0.0,
               .value = (moment_ + moment(added_arms(displacement, pressure_share_), force)) / arm};
  row.on_force.col(kForward) = at.y / arm;
  row.on_force.col(kDown) = -at.x / arm;
  row.on_displacement.col(kDown) = force.col(kForward) / arm;
  row.on_displacement.col(kForward) = -pressure_share_ * force.col(kDown) / arm;
  return row;
}

/// The body's own displacement, of the lever arms, is taken as it is: it hardly changes in a step.
DriveRow GivenMoment::row_of_pair(const ContactState& state, double arm) const {
  const auto [pushed_back, on_force] = pushback(state);
  DriveRow row{.on_force = VectorField::Zero(state.force.rows(), 3),
               .on_displacement = {},
               .on_speed = 0.0,
               .value = (moment_ + state.arms.radius * pushed_back) / arm};
  row.on_force.col(kForward) = (state.arms.y + state.surface.rolling_displacement(state.force).col(kDown)) / arm;
  row.on_force.col(kDown) = -state.arms.x / arm;
  if (on_force.rows() > 0) {
    row.on_force -= state.arms.radius / arm * on_force;
    row.value -= state.arms.radius / arm * (on_force * state.force).sum();
  }
  return row;
}

DriveRow GivenSpeed::row(const ContactState& state, double speed_force) const {
  return {.on_force = VectorField::Zero(state.force.rows(), 3),
          .on_displacement = {},
          .on_speed = speed_force,
          .value = ratio_ * speed_force};
}

}  // namespace viscoroll::detail
