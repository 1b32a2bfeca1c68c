#include "contact/drive.hpp"

#include <utility>

namespace viscoroll::detail {

SlopeForce slope_force(const ContactState& state) {
  const auto& [surface, arms, force, displacement] = state;
  const bool is_rigid = surface.deforming() == Deforming::counterbody;
  SlopeForce result{.force = is_rigid ? 0.0 : surface.slope_force(force), .derivative = {}};
  if (!is_rigid && arms.slope.size() == 0) return result;
  result.derivative = VectorField::Zero(force.rows(), 3);
  result.derivative.col(kDown) = is_rigid ? Eigen::ArrayXd(-arms.x / arms.radius) : Eigen::ArrayXd(-arms.slope);
  result.force += (result.derivative * force).sum();
  return result;
}

double moment_about_center(const ContactState& state, double pressure_work_factor) {
  const auto& [surface, arms, force, displacement] = state;
  return moment(displaced(arms, displacement, pressure_work_factor), force) - arms.radius * slope_force(state).force;
}

double DriveRow::of(const VectorField& force, const VectorField& displacement, double creepage) const {
  double sum = (force_coefficients * force).sum() + creepage_coefficient * creepage;
  if (displacement_coefficients.rows() > 0) sum += (displacement_coefficients * displacement).sum();
  return sum;
}

namespace {

/// Add `factor` times the slope force to the forces that balance those of a row.
DriveRow with_slope_force(DriveRow row, const ContactState& state, double factor) {
  const auto [slope_force_at_state, derivative] = slope_force(state);
  row.value += factor * slope_force_at_state;
  if (derivative.rows() > 0) {
    row.force_coefficients -= factor * derivative;
    row.value -= factor * (derivative * state.force).sum();
  }
  return row;
}

}  // namespace

DriveRow GivenForce::row(const ContactState& state, double) const {
  DriveRow row{.force_coefficients = VectorField::Zero(state.force.rows(), 3),
               .displacement_coefficients = {},
               .creepage_coefficient = 0.0,
               .value = -force_};
  row.force_coefficients.col(kForward).setOnes();
  return with_slope_force(std::move(row), state, 1.0);
}

DriveRow GivenMoment::row(const ContactState& state, double) const {
  const auto& [surface, arms, force, displacement] = state;
  const double arm = arms.y.maxCoeff();  // any length turns the condition into one on a force
  if (surface.deforming() != Deforming::rolling) return row_of_pair(state, arm);
  const MomentArms at = displaced(arms, displacement, pressure_work_factor_);
  DriveRow row{.force_coefficients = moment_per_force(at) / arm,
               .displacement_coefficients = VectorField::Zero(force.rows(), 3),
               .creepage_coefficient = 0.0,
               .value = (moment_ + moment(added_arms(displacement, pressure_work_factor_), force)) / arm};
  row.displacement_coefficients.col(kDown) = force.col(kForward) / arm;
  row.displacement_coefficients.col(kForward) = -pressure_work_factor_ * force.col(kDown) / arm;
  return with_slope_force(std::move(row), state, arms.radius / arm);
}

/// The displacement of the rolling body in the moment arms is kept at its current value, since it hardly changes in a
/// step.
DriveRow GivenMoment::row_of_pair(const ContactState& state, double arm) const {
  DriveRow row{.force_coefficients = moment_per_force(displaced(state.arms, state.displacement, 0.0)) / arm,
               .displacement_coefficients = {},
               .creepage_coefficient = 0.0,
               .value = moment_ / arm};
  return with_slope_force(std::move(row), state, state.arms.radius / arm);
}

DriveRow GivenCreepage::row(const ContactState& state, double creepage_force) const {
  return {.force_coefficients = VectorField::Zero(state.force.rows(), 3),
          .displacement_coefficients = {},
          .creepage_coefficient = creepage_force,
          .value = creepage_ * creepage_force};
}

}  // namespace viscoroll::detail
