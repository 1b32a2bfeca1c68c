#include "transient/contact_numbers.hpp"

#include <cmath>
#include <limits>

#include "contact/contact_extent.hpp"
#include "rolling/refusals.hpp"
#include "transient/center_forces.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;

double flat_patch(const SurfaceGrid& grid) { return std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing; }

void tell_extent(const CreepingPair& pair, const Touch& touch, RollingInstant& now) {
  const SurfaceWindow& nodes = touch.place.nodes;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(touch.place.count, 1);
  const ArrayXd forces = -touch.contact.force.col(kDown) / touch.yielding.sum;
  now.penetration = touch.contact.penetration;
  if (!std::isnan(now.penetration)) require_depth(pair.pair, now.load, now.penetration);
  const std::vector<Eigen::Index>& contact = touch.contact.nodes;
  const ArrayXd touching = weights(contact).square() * nodes.patch_area(contact);
  const ContactExtent extent = contact_extent(nodes, contact, touching, 0.0);
  now.contact_area = extent.area;
  now.semi_axis_x = extent.semi_axis_x;
  now.semi_axis_z = extent.semi_axis_z.value_or(std::numeric_limits<double>::quiet_NaN());
  now.max_pressure = (forces / weights).maxCoeff() / flat_patch(nodes.grid());
}

CenterPower tell_moments(const CreepingPair& pair, const Touch& touch, RollingInstant& now) {
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(touch.place.count, 1);
  const VectorField force = touch.contact.force.colwise() * weights / touch.yielding.sum;
  const std::vector<HalfField> deformed = detail::deformed(pair, touch);
  const ActingPlaces at{pair, touch.place, deformed};
  now.resisting_torque = -(touch.place.lever * force.col(kDown)).sum();
  now.driving_force = (force_on_center(at) * force).sum();
  now.driving_torque = (moment_about_center(at) * force).sum();
  CenterPower power{.along_track = (force_along_track(at, touch.contact.penetration) * force).sum()};
  if (!pair.has_friction()) return power;
  const VectorField slopes = counterpart_slopes(at);
  if (slopes.rows() > 0) power.creeping = (slopes * force).sum();
  return power;
}

}  // namespace viscoroll::detail
