#include "transient/contact_numbers.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "contact/contact_extent.hpp"
#include "contact/lever_arms.hpp"
#include "surface/patch_slope.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;

/// D_2, the force of the pressure along the counterpart's own deformed surface: theory.md section 15.
double pushback(const CreepingPair& pair, const Touch& touch, const ArrayXd& pressing, double resisting_torque) {
  if (pair.bodies.size() == 1) {
    return pair.bodies.front().rolls ? 0.0 : resisting_torque / relative_radius(pair.pair);
  }
  const SurfaceGrid& grid = pair.nodes.grid;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(touch.place.count, 1);
  const ArrayXd depth = deformed(pair, touch, 1).reshaped().array() / weights;
  return (pressing * patch_slope(depth, pair.half_nodes(), grid.radius * grid.phi_spacing)).sum();
}

}  // namespace

double flat_patch(const SurfaceGrid& grid) { return std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing; }

void tell_extent(const CreepingPair& pair, const Touch& touch, RollingInstant& now) {
  const SurfaceWindow& nodes = touch.place.nodes;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(touch.place.count, 1);
  const ArrayXd forces = -touch.contact.force.col(kDown) / touch.yielding.sum;
  now.penetration = touch.contact.penetration;
  const double coating_thickness = thickness(pair.pair);
  if (now.penetration >= coating_thickness) {
    reject("load", "small enough for the coating",
           text(now.load) + " " + std::string(pair.pair.body.form.load_unit) + " (it is pressed " +
               rounded(now.penetration) + " m into a coating of " + text(coating_thickness) + " m)");
  }

  const ArrayXd patches = nodes.patch_area();
  ArrayXd touching = ArrayXd::Zero(forces.size());
  for (const Eigen::Index node : touch.contact.nodes) touching[node] = weights[node] * weights[node] * patches[node];
  const ContactExtent extent = contact_extent(nodes, touching, 0.0);
  now.contact_area = extent.area;
  now.semi_axis_x = extent.semi_axis_x;
  now.semi_axis_z = extent.semi_axis_z.value_or(std::numeric_limits<double>::quiet_NaN());
  now.max_pressure = (forces / weights).maxCoeff() / flat_patch(nodes.grid());
}

void tell_moments(const CreepingPair& pair, const Touch& touch, RollingInstant& now) {
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(touch.place.count, 1);
  const VectorField force = touch.contact.force.colwise() * weights / touch.yielding.sum;
  const double radius = pair.nodes.grid.radius;
  const double turning = pair.pair.on.curvatures.along;  // of what it rolls on [1/m]
  now.resisting_torque = -(touch.place.lever * force.col(kDown)).sum();
  const double pushed_back = pushback(pair, touch, -force.col(kDown), now.resisting_torque);
  now.driving_force = pushed_back - turning * now.resisting_torque;
  now.driving_torque = radius / relative_radius(pair.pair) * now.resisting_torque - radius * pushed_back;
  if (pair.coating().components() == 1) return;
  LeverArms arms{.x = touch.place.lever,
                 .y = ArrayXd::Constant(weights.size(), radius - touch.contact.penetration),
                 .radius = radius};
  if (pair.compliance == Compliance::vertical) {
    arms.x -= along(touch.place.axes[kForward], deformed(pair, touch, 0)).reshaped().array() / weights;
  }
  if (pair.has_friction()) now.driving_force = -force.col(kForward).sum();
  now.driving_torque = moment(arms, force);
}

}  // namespace viscoroll::detail
