#include "transient/contact_search.hpp"

#include <utility>

#include "rolling/initial_gap.hpp"
#include "transient/center_forces.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;
using Eigen::Index;

namespace {

/// @param[in] level_axes same as in `StepOperator::Part`
StepOperator surface_of(const InstantContact& instant, const std::vector<Axes>& level_axes) {
  std::vector<StepOperator::Part> parts;
  for (std::size_t b = 0; b < instant.instantaneous.of_bodies.size(); ++b) {
    const InstantaneousTables& body = instant.instantaneous.of_bodies[b];
    parts.push_back({.share = body.share / instant.instantaneous.sum,
                     .tables = body.tables.get(),
                     .axes = &instant.place.axes[b],
                     .level_axes = &level_axes[b]});
  }
  return {std::move(parts), instant.checkpoint};
}

/// Fraction of its speed by which the counterbody's surface lags on average between two positions, by Simpson's rule;
/// depths are quadratic in the distance.
ArrayXd mean_delay(const ViscoelasticPair& pair, const SurfaceWindow& from, const SurfaceWindow& to) {
  if (pair.pair.on->curvatures().along == 0.0) return ArrayXd::Zero(to.shape().size());
  const SurfaceWindow between(to.grid(), to.window(), 0.5 * (from.shift() + to.shift()));
  return (counterbody_delay(from, {}, pair.pair) + 4.0 * counterbody_delay(between, {}, pair.pair) +
          counterbody_delay(to, {}, pair.pair)) /
         6.0;
}

/// Slip of nodes over the counterbody in a step, along x and z.
struct StepSlip {
  Eigen::ArrayX2d known;                         ///< without the contributions of the new forces and of the center
  Eigen::ArrayX2d slip_per_center_displacement;  ///< per unit displacement of the center
};

/// Slip of nodes over the counterbody. Rows of the counterbody stay matched with those of the rolling body,
/// but its material passes as far as the center moves. Over the difference of both distances, a node also passes along
/// the counterbody's own displacement, with the slope before the step.
StepSlip step_slip(const ViscoelasticPair& pair, const ContactPlace& before, const InstantContact& instant,
                   const Departure& departure) {
  const ContactPlace& place = instant.place;
  const ArrayXd delay = mean_delay(pair, before.nodes, place.nodes);
  StepSlip slip{.known = Eigen::ArrayX2d::Zero(delay.size(), 2),
                .slip_per_center_displacement = Eigen::ArrayX2d::Zero(delay.size(), 2)};
  slip.known.col(0) = place.nodes.rolled() - before.nodes.rolled();
  slip.known.col(1) = place.nodes.z() - before.nodes.z();
  slip.slip_per_center_displacement.col(0) = 1.0 - delay;
  const VectorField slopes = counterbody_slopes({pair, before, departure.loaded_displacements});
  const double rolled = pair.nodes.grid.radius * departure.turned;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(place.count, 1);
  for (const auto& [column, axis] : {std::pair{0, kForward}, std::pair{1, kSideways}}) {
    if (slopes.rows() > 0) {
      slip.known.col(column) -= rolled * slopes.col(axis);
      slip.slip_per_center_displacement.col(column) += slopes.col(axis);
    }
    slip.known.col(column) *= weights;
    slip.slip_per_center_displacement.col(column) *= weights;
    slip.known.col(column) -= against(axis, place.axes, instant.known).reshaped().array();
    slip.known.col(column) += against(axis, before.axes, departure.loaded_displacements).reshaped().array();
  }
  return slip;
}

}  // namespace

StickSlip solve_frictionless(const ViscoelasticPair& pair, const InstantContact& instant, const LastForces& last,
                             double load, ContactInverse& inverse) {
  const Index half_nodes = pair.half_nodes();
  const ArrayXd weights = half_weights(half_nodes);
  const StepOperator surface = surface_of(instant, instant.place.axes);
  ElasticContactProblem problem{.surface = surface,
                                .gap = weights.matrix().asDiagonal() * as_field(instant.place.gap, half_nodes),
                                .weights = weights.matrix().replicate(1, instant.place.count),
                                .load = load};
  problem.gap += known_gap(pair, instant);
  PressedNodes contact =
      solve_elastic_contact(problem, -carried_forces(pair, instant.place, last, load).col(kDown), inverse);
  StickSlip result;
  result.force = VectorField::Zero(contact.pressing.size(), 3);
  result.force.col(kDown) = -contact.pressing;
  result.penetration = *contact.penetration;
  result.nodes = std::move(contact.nodes);
  return result;
}

StickSlip solve_frictional(const ViscoelasticPair& pair, const InstantContact& instant, const LastForces& last,
                           const Departure& departure, double load, const CenterCondition& center,
                           ContactStiffness& stiffness) {
  const ContactPlace& place = instant.place;
  const SurfaceGrid& grid = pair.nodes.grid;
  const double compliance = instant.instantaneous.sum;
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(place.count, 1);
  const ContactPlace before =
      place_of(pair, place.first,
               SurfaceWindow(grid, place.nodes.window(), place.nodes.shift() - departure.turned / grid.phi_spacing));
  StepSlip slip = step_slip(pair, before, instant, departure);
  slip.known += center.coasted * slip.slip_per_center_displacement;
  const std::vector<Axes> level_axes = axes_at(pair, SurfaceWindow(grid, place.nodes.window()));
  const StepOperator surface = surface_of(instant, level_axes);
  const CenterCondition scaled{.force = center.force,
                               .torque = center.torque,
                               .displacement = compliance * center.displacement,
                               .value = compliance * center.value};
  const auto row = [&](const std::vector<HalfField>& displaced) {
    std::vector<HalfField> deformed = instant.known;
    for (std::size_t b = 0; b < displaced.size(); ++b) {
      const StepOperator::Part& part = surface.parts()[b];
      deformed[b] += part.share * displaced[b];
    }
    return center_row({pair, place, deformed}, scaled);
  };
  const StickSlipProblem problem{.surface = surface,
                                 .gap = weights * place.gap + known_gap(pair, instant).reshaped().array(),
                                 .known_slip = std::move(slip.known),
                                 .slip_per_center_displacement = std::move(slip.slip_per_center_displacement),
                                 .weights = weights,
                                 .load = compliance * load,
                                 .friction = pair.friction,
                                 .center_row = row,
                                 .center_row_needs_displacements = depends_on_displacements(pair, center)};
  StickSlip result = solve_stick_slip(problem, carried_forces(pair, place, last, problem.load), stiffness);
  result.center_displacement += center.coasted;
  return result;
}

StickSlip solve_lifted(const ViscoelasticPair& pair, const InstantContact& instant, const CenterCondition& center) {
  const Index half_nodes = pair.half_nodes();
  const HalfField weights = half_weights(half_nodes).matrix().replicate(1, instant.place.count);
  StickSlip result;
  result.force = VectorField::Zero(weights.size(), 3);
  result.penetration =
      (as_field(instant.place.gap, half_nodes) + known_gap(pair, instant).cwiseQuotient(weights)).minCoeff();
  result.center_displacement = center.coasted + (center.displacement != 0.0 ? center.value / center.displacement : 0.0);
  result.slip = Eigen::ArrayX2d::Zero(weights.size(), 2);
  return result;
}

}  // namespace viscoroll::detail
