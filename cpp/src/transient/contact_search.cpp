#include "transient/contact_search.hpp"

#include <utility>

#include "rolling/initial_gap.hpp"
#include "transient/center_forces.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;
using Eigen::Index;

namespace {

/// @param[in] level_axes same as in `StepOperator::Part`
StepOperator surface_of(const Touch& touch, const std::vector<Axes>& level_axes) {
  std::vector<StepOperator::Part> parts;
  for (std::size_t b = 0; b < touch.yielding.of_bodies.size(); ++b) {
    const YieldingTables& body = touch.yielding.of_bodies[b];
    parts.push_back({.share = body.share / touch.yielding.sum,
                     .tables = body.tables.get(),
                     .axes = &touch.place.axes[b],
                     .level_axes = &level_axes[b]});
  }
  return {std::move(parts), touch.checkpoint};
}

/// Fraction of its speed by which the counterbody's surface lags on average between two positions, by Simpson's rule;
/// depths are quadratic in the distance.
ArrayXd mean_delay(const CreepingPair& pair, const SurfaceWindow& from, const SurfaceWindow& to) {
  if (pair.pair.on->curvatures().along == 0.0) return ArrayXd::Zero(to.shape().size());
  const SurfaceWindow between(to.grid(), to.window(), 0.5 * (from.shift() + to.shift()));
  return (counterpart_delay(from, {}, pair.pair) + 4.0 * counterpart_delay(between, {}, pair.pair) +
          counterpart_delay(to, {}, pair.pair)) /
         6.0;
}

/// Displacements of nodes over the counterbody in a step, along x and z.
struct Ways {
  Eigen::ArrayX2d known;      ///< without those by the new forces and by the center
  Eigen::ArrayX2d by_center;  ///< per unit displacement of the center
};

/// Displacements of nodes over the counterbody. Rows of the counterbody stay matched with those of the rolling body,
/// but its material passes as far as the center moves. Over the difference of both distances, a node also passes along
/// the counterbody's own displacement, with the slope before the step.
Ways ways_of(const CreepingPair& pair, const ContactPlace& before, const Touch& touch, const Departure& departure) {
  const ContactPlace& place = touch.place;
  const ArrayXd delay = mean_delay(pair, before.nodes, place.nodes);
  Ways ways{.known = Eigen::ArrayX2d::Zero(delay.size(), 2), .by_center = Eigen::ArrayX2d::Zero(delay.size(), 2)};
  ways.known.col(0) = place.nodes.rolled() - before.nodes.rolled();
  ways.known.col(1) = place.nodes.z() - before.nodes.z();
  ways.by_center.col(0) = 1.0 - delay;
  const VectorField slopes = counterpart_slopes({pair, before, departure.borne});
  const double rolled = pair.nodes.grid.radius * departure.turned;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(place.count, 1);
  for (const auto& [column, axis] : {std::pair{0, kForward}, std::pair{1, kSideways}}) {
    if (slopes.rows() > 0) {
      ways.known.col(column) -= rolled * slopes.col(axis);
      ways.by_center.col(column) += slopes.col(axis);
    }
    ways.known.col(column) *= weights;
    ways.by_center.col(column) *= weights;
    ways.known.col(column) -= against(axis, place.axes, touch.known).reshaped().array();
    ways.known.col(column) += against(axis, before.axes, departure.borne).reshaped().array();
  }
  return ways;
}

}  // namespace

StickSlip touch_smooth(const CreepingPair& pair, const Touch& touch, const LastForces& last, double load,
                       ContactInverse& inverse) {
  const Index half_nodes = pair.half_nodes();
  const ArrayXd weights = half_weights(half_nodes);
  const StepOperator surface = surface_of(touch, touch.place.axes);
  ElasticContactProblem problem{.surface = surface,
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
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(place.count, 1);
  const ContactPlace before =
      place_of(pair, place.first,
               SurfaceWindow(grid, place.nodes.window(), place.nodes.shift() - departure.turned / grid.phi_spacing));
  Ways ways = ways_of(pair, before, touch, departure);
  ways.known += center.coasted * ways.by_center;
  const std::vector<Axes> level_axes = axes_at(pair, SurfaceWindow(grid, place.nodes.window()));
  const StepOperator surface = surface_of(touch, level_axes);
  const CenterCondition scaled{.force = center.force,
                               .torque = center.torque,
                               .way = compliance * center.way,
                               .value = compliance * center.value};
  const auto row = [&](const std::vector<HalfField>& displaced) {
    std::vector<HalfField> deformed = touch.known;
    for (std::size_t b = 0; b < displaced.size(); ++b) {
      const StepOperator::Part& part = surface.parts()[b];
      deformed[b] += part.share * displaced[b];
    }
    return center_row({pair, place, deformed}, scaled);
  };
  const StickSlipProblem problem{.surface = surface,
                                 .gap = weights * place.gap + known_gap(pair, touch).reshaped().array(),
                                 .way = std::move(ways.known),
                                 .by_center = std::move(ways.by_center),
                                 .weights = weights,
                                 .load = compliance * load,
                                 .friction = pair.friction,
                                 .center = row,
                                 .center_moves = depends_on_displacements(pair, center)};
  StickSlip result = solve_stick_slip(problem, carried_forces(pair, place, last, problem.load), stiffness);
  result.way += center.coasted;
  return result;
}

StickSlip touch_lifted(const CreepingPair& pair, const Touch& touch, const CenterCondition& center) {
  const Index half_nodes = pair.half_nodes();
  const HalfField weights = half_weights(half_nodes).matrix().replicate(1, touch.place.count);
  StickSlip result;
  result.force = VectorField::Zero(weights.size(), 3);
  result.penetration =
      (as_field(touch.place.gap, half_nodes) + known_gap(pair, touch).cwiseQuotient(weights)).minCoeff();
  result.way = center.coasted + (center.way != 0.0 ? center.value / center.way : 0.0);
  result.slip = Eigen::ArrayX2d::Zero(weights.size(), 2);
  return result;
}

}  // namespace viscoroll::detail
