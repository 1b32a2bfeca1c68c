#include "transient/contact_search.hpp"

#include <utility>

namespace viscoroll::detail {

using Eigen::ArrayXd;
using Eigen::Index;

StickSlip touch_smooth(const CreepingPair& pair, const Touch& touch, const LastForces& last, double load,
                       ContactInverse& inverse) {
  const Index half_nodes = pair.half_nodes();
  const ArrayXd weights = half_weights(half_nodes);
  std::vector<StepOperator::Part> parts;
  parts.reserve(pair.bodies.size());
  for (const YieldingTables& body : touch.yielding.of_bodies) {
    parts.push_back({body.share / touch.yielding.sum, body.tables.get()});
  }
  const StepOperator surface(std::move(parts));
  ElasticContactProblem problem{.surface = surface,
                                .down = touch.place.axes[kDown],
                                .gap = weights.matrix().asDiagonal() * as_field(touch.place.gap, half_nodes),
                                .weights = weights.matrix().replicate(1, touch.place.count),
                                .load = load};
  problem.gap += known_gap(pair, touch);
  PressedNodes contact =
      solve_elastic_contact(problem, -carried_forces(pair, touch.place, last, load).col(kDown), inverse);
  StickSlip result;
  result.force = VectorField::Zero(contact.pressing.size(), 3);
  result.force.col(kDown) = -contact.pressing;
  result.penetration = *contact.penetration;
  result.nodes = std::move(contact.nodes);
  return result;
}

StickSlip touch_with_friction(const CreepingPair& pair, const Touch& touch, const LastForces& last,
                              const Departure& departure, double load, const CenterCondition& center,
                              ContactStiffness& stiffness) {
  const ContactPlace& place = touch.place;
  const SurfaceGrid& grid = pair.nodes.grid;
  const double compliance = touch.yielding.sum;
  const HalfField& known = touch.known.front();
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(place.count, 1);
  const SurfaceWindow before(grid, place.nodes.window(), place.nodes.shift() - departure.turned / grid.phi_spacing);
  const Axes axes_before = axes_at(pair, before);
  const auto part = [](const Axes& axes, std::size_t axis, const HalfField& field) -> ArrayXd {
    return along(axes[axis], field).reshaped();
  };
  const StickSlipProblem problem{
      .tables = *touch.yielding.of_bodies.front().tables,
      .axes = place.axes,
      .gap = weights * place.gap + part(place.axes, kDown, known),
      .forward_way = weights * (place.nodes.x() - before.x()) - part(place.axes, kForward, known) +
                     part(axes_before, kForward, departure.borne),
      .sideways_way = weights * (place.nodes.z() - before.z()) - part(place.axes, kSideways, known) +
                      part(axes_before, kSideways, departure.borne),
      .weights = weights,
      .load = compliance * load,
      .friction = pair.friction,
      .center = {.force = center.force, .way = compliance * center.way, .value = compliance * center.value}};
  return solve_stick_slip(problem, carried_forces(pair, place, last, problem.load), stiffness);
}

StickSlip touch_lifted(const CreepingPair& pair, const Touch& touch, const CenterCondition& center) {
  const Index half_nodes = pair.half_nodes();
  const HalfField weights = half_weights(half_nodes).matrix().replicate(1, touch.place.count);
  StickSlip result;
  result.force = VectorField::Zero(weights.size(), 3);
  result.penetration =
      (as_field(touch.place.gap, half_nodes) + known_gap(pair, touch).cwiseQuotient(weights)).minCoeff();
  result.way = center.way != 0.0 ? center.value / center.way : 0.0;
  result.slip = Eigen::ArrayX2d::Zero(weights.size(), 2);
  return result;
}

}  // namespace viscoroll::detail
