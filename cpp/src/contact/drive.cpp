#include "contact/drive.hpp"

#include <utility>

namespace viscoroll::detail {

SlopeForce slope_force(const ContactState& state) {
  const auto& [surface, arms, force, displacement] = state;
  const bool is_rigid = surface.deforming() == Deforming::counterbody;
  SlopeForce result{.force = is_rigid ? 0.0 : surface.slope_force(force), .on_force = {}};
  if (!is_rigid && arms.slope.size() == 0) return result;
  result.on_force = VectorField::Zero(force.rows(), 3);
  result.on_force.col(kDown) = is_rigid ? Eigen::ArrayXd(-arms.x / arms.radius) : Eigen::ArrayXd(-arms.slope);
  result.force += (result.on_force * force).sum();
  return result;
}

double moment_about_center(const ContactState& state, double pressure_share) {
  const auto& [surface, arms, force, displacement] = state;
  return moment(displaced(arms, displacement, pressure_share), force) - arms.radius * slope_force(state).force;
}

double DriveRow::of(const VectorField& force, const VectorField& displacement, double creepage) const {
  double sum = (on_force * force).sum() + on_creepage * creepage;
  if (on_displacement.rows() > 0) sum += (on_displacement * displacement).sum();
  return sum;
}

namespace {

/// Add `factor` times the slope force to the forces that balance those of a row.
DriveRow with_slope_force(DriveRow row, const ContactState& state, double factor) {
  const auto [pushed_back, on_force] = slope_force(state);
  row.value += factor * pushed_back;
  if (on_force.rows() > 0) {
    row.on_force -= factor * on_force;
    row.value -= factor * (on_force * state.force).sum();
  }
  return row;
}

}  // namespace

DriveRow GivenForce::row(const ContactState& state, double) const {
  DriveRow row{.on_force = VectorField::Zero(state.force.rows(), 3),
               .on_displacement = {},
               .on_creepage = 0.0,
               .value = -force_};
  row.on_force.col(kForward).setOnes();
  return with_slope_force(std::move(row), state, 1.0);
}

DriveRow GivenMoment::row(const ContactState& state, double) const {
  const auto& [surface, arms, force, displacement] = state;
  const double arm = arms.y.maxCoeff();  // any length turns the condition into one on a force
  if (surface.deforming() != Deforming::rolling) return row_of_pair(state, arm);
  const MomentArms at = displaced(arms, displacement, pressure_share_);
  DriveRow row{.on_force = moment_per_force(at) / arm,
               .on_displacement = VectorField::Zero(force.rows(), 3),
               .on_creepage = 0.0,
               .value = (moment_ + moment(added_arms(displacement, pressure_share_), force)) / arm};
  row.on_displacement.col(kDown) = force.col(kForward) / arm;
  row.on_displacement.col(kForward) = -pressure_share_ * force.col(kDown) / arm;
  return with_slope_force(std::move(row), state, arms.radius / arm);
}

/// The displacement of the rolling body in the moment arms is kept at its current value, since it hardly changes in a
/// step.
DriveRow GivenMoment::row_of_pair(const ContactState& state, double arm) const {
  DriveRow row{.on_force = moment_per_force(displaced(state.arms, state.displacement, 0.0)) / arm,
               .on_displacement = {},
               .on_creepage = 0.0,
               .value = moment_ / arm};
  return with_slope_force(std::move(row), state, state.arms.radius / arm);
}

DriveRow GivenCreepage::row(const ContactState& state, double creepage_force) const {
  return {.on_force = VectorField::Zero(state.force.rows(), 3),
          .on_displacement = {},
          .on_creepage = creepage_force,
          .value = creepage_ * creepage_force};
}

}  // namespace viscoroll::detail
