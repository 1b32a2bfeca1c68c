#include "transient/contact_numbers.hpp"

#include <cmath>
#include <limits>

#include "contact/contact_extent.hpp"
#include "rolling/input_checks.hpp"
#include "transient/center_forces.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;

double flat_patch(const SurfaceGrid& grid) { return std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing; }

void set_extent(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now) {
  const SurfaceWindow& nodes = instant.place.nodes;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(instant.place.count, 1);
  const ArrayXd forces = -instant.contact.force.col(kDown) / instant.instantaneous.sum;
  now.penetration = instant.contact.penetration;
  if (!std::isnan(now.penetration)) require_depth(pair.pair, now.load, now.penetration);
  const std::vector<Eigen::Index>& contact = instant.contact.nodes;
  const ArrayXd touching = weights(contact).square() * nodes.patch_area(contact);
  const ContactExtent extent = contact_extent(nodes, contact, touching, 0.0);
  now.contact_area = extent.area;
  now.semi_axis_x = extent.semi_axis_x;
  now.semi_axis_z = extent.semi_axis_z.value_or(std::numeric_limits<double>::quiet_NaN());
  now.max_pressure = (forces / weights).maxCoeff() / flat_patch(nodes.grid());
}

CenterPower set_moments(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now) {
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(instant.place.count, 1);
  const VectorField force = instant.contact.force.colwise() * weights / instant.instantaneous.sum;
  const std::vector<HalfField> deformed = detail::deformed(pair, instant);
  const ActingPlaces at{pair, instant.place, deformed};
  now.resisting_torque = -(instant.place.lever * force.col(kDown)).sum();
  now.driving_force = (force_on_center(at) * force).sum();
  now.driving_torque = (moment_about_center(at) * force).sum();
  CenterPower power{.along_track = (force_along_track(at, instant.contact.penetration) * force).sum()};
  if (!pair.has_friction()) return power;
  const VectorField slopes = counterbody_slopes(at);
  if (slopes.rows() > 0) power.creeping = (slopes * force).sum();
  return power;
}

}  // namespace viscoroll::detail
