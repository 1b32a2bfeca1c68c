#include "contact/drive.hpp"

namespace viscoroll::detail {

double DriveRow::of(const VectorField& force, const VectorField& displacement, double speed_ratio) const {
  double sum = (on_force * force).sum() + on_speed * speed_ratio;
  if (on_displacement.rows() > 0) sum += (on_displacement * displacement).sum();
  return sum;
}

DriveRow GivenForce::row(const LeverArms&, const VectorField& force, const VectorField&, double) const {
  DriveRow row{
      .on_force = VectorField::Zero(force.rows(), 3), .on_displacement = {}, .on_speed = 0.0, .value = -force_};
  row.on_force.col(kForward).setOnes();
  return row;
}

DriveRow GivenMoment::row(const LeverArms& arms, const VectorField& force, const VectorField& displacement,
                          double) const {
  const double arm = arms.y.maxCoeff();  // any length turns the condition into one on a force
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

DriveRow GivenSpeed::row(const LeverArms&, const VectorField& force, const VectorField&, double speed_force) const {
  return {.on_force = VectorField::Zero(force.rows(), 3),
          .on_displacement = {},
          .on_speed = speed_force,
          .value = ratio_ * speed_force};
}

}  // namespace viscoroll::detail
