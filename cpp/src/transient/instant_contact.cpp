#include "transient/instant_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/contact_extent.hpp"
#include "rolling/initial_gap.hpp"
#include "rolling/input_checks.hpp"
#include "transient/center_motion.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Displacements of all bodies along an axis, opposite to the direction of the forces.
/// @param[in] axes,fields of every body
HalfField against(Axis axis, const std::vector<Axes>& axes, const std::vector<HalfField>& fields) {
  HalfField sum = along(axes.front()[static_cast<std::size_t>(axis)], fields.front());
  for (std::size_t b = 1; b < fields.size(); ++b) sum += along(axes[b][static_cast<std::size_t>(axis)], fields[b]);
  return sum;
}

/// Displacements of all bodies that remain from earlier loads; they open the gap.
HalfField known_gap(const ViscoelasticPair& pair, const InstantContact& instant) {
  if (pair.coating().components() > 1) return against(kDown, instant.place.axes, instant.known);
  HalfField known = instant.known.front();
  for (std::size_t b = 1; b < instant.known.size(); ++b) known += instant.known[b];
  return known;
}

/// Forces of the contact on a body's nodes in the window, by their components.
HalfField by_components(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body) {
  const VectorField& force = instant.contact.force;
  return pair.coating().components() == 1 ? as_field(-force.col(kDown), pair.half_nodes())
                                          : on_plane(instant.place.axes[body], force);
}

/// Fraction of the window that the first guess of the contact covers.
constexpr double kContactShare = 0.8;

/// Last forces at the positions where the contact is now. They stay at the lowest point while nodes pass.
VectorField carried(Index half_nodes, const ContactPlace& place, const LastForces& last_window) {
  VectorField force = VectorField::Zero(half_nodes * place.count, 3);
  const double lowest =
      place.nodes.shift() - last_window.lowest + 0.5 * static_cast<double>(last_window.count - place.count);
  const auto whole = static_cast<Index>(std::floor(lowest));
  const double ahead = lowest - static_cast<double>(whole);
  const auto add = [&](Index row, Index last, double share) {
    if (last < 0 || last >= last_window.count) return;
    force.middleRows(half_nodes * row, half_nodes) +=
        share * last_window.force.middleRows(half_nodes * last, half_nodes);
  };
  for (Index row = 0; row < place.count; ++row) {
    add(row, row + whole, 1.0 - ahead);
    add(row, row + whole + 1, ahead);
  }
  return force;
}

/// Forces to start from: the last forces, scaled to a new load. For a first contact, the pressures in a window that is
/// a little wider than the contact are guessed; over uneven ground, they begin at the highest point.
VectorField carried_forces(const ViscoelasticPair& pair, const ContactPlace& place, const LastForces& last,
                           double load) {
  VectorField guess = carried(pair.half_nodes(), place, last);
  if (!(guess.col(kDown) < 0.0).any()) {
    const bool is_smooth = place.heights.ground.size() == 0;
    const double closest = is_smooth ? 0.0 : place.gap.minCoeff();
    const double edge = is_smooth ? place.gap[0] : place.gap.maxCoeff() - closest;
    guess.col(kDown) = -(kContactShare * kContactShare * edge - (place.gap - closest)).max(0.0);
  }
  return load / -(place.weights * guess.col(kDown)).sum() * guess;
}

/// Opening of the gap between surfaces that support no load [m].
ArrayXd free_gap(const ViscoelasticPair& pair, const InstantContact& instant) {
  return instant.place.gap + known_gap(pair, instant).reshaped().array() / instant.place.weights;
}

/// Pressing forces to start from, if the load is a result: the last forces or, after a flight, those of the nodes that
/// overlap.
ArrayXd overlapping_forces(const ViscoelasticPair& pair, const InstantContact& instant, const LastForces& last,
                           const ArrayXd& overlap, double compliance) {
  constexpr double kShare = 0.1;  // of the stiffness of single nodes, because neighbors share the load
  ArrayXd carried_over = -instant.instantaneous.sum * carried(pair.half_nodes(), instant.place, last).col(kDown);
  if ((carried_over > 0.0).any()) return carried_over;
  return kShare / compliance * overlap.max(0.0);
}

/// Contact of bodies that do not touch at a penetration.
StickSlip without_contact(Index nodes, double penetration) {
  StickSlip result;
  result.force = VectorField::Zero(nodes, 3);
  result.penetration = penetration;
  result.slip = Eigen::ArrayX2d::Zero(nodes, 2);
  return result;
}

/// Compliance of all bodies for the forces of the contact.
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
  for (const auto& [column, axis] : {std::pair{0, kForward}, std::pair{1, kSideways}}) {
    if (slopes.rows() > 0) {
      slip.known.col(column) -= rolled * slopes.col(axis);
      slip.slip_per_center_displacement.col(column) += slopes.col(axis);
    }
    slip.known.col(column) *= place.weights;
    slip.slip_per_center_displacement.col(column) *= place.weights;
    slip.known.col(column) -= against(axis, place.axes, instant.known).reshaped().array();
    slip.known.col(column) += against(axis, before.axes, departure.loaded_displacements).reshaped().array();
  }
  return slip;
}

}  // namespace

StickSlip solve_frictionless(const ViscoelasticPair& pair, const InstantContact& instant, const LastForces& last,
                             const ApproachCondition& condition, ContactInverse& inverse) {
  const Index half_nodes = pair.half_nodes();
  const ContactPlace& place = instant.place;
  const StepOperator surface = surface_of(instant, place.axes);
  // Tolerances are relative to the penetration, which is therefore measured from the highest point of the window.
  ApproachCondition from_top = condition;
  from_top.coasted += place.top;
  if (condition.force == 0.0) {
    from_top.value += condition.penetration * place.top;
    from_top.coasted = 0.0;
  }
  if (condition.penetration == 0.0) from_top.coasted = 0.0;
  ElasticContactProblem problem{.surface = surface,
                                .gap = as_field(place.weights * (place.gap + place.top), half_nodes),
                                .weights = as_field(place.weights, half_nodes),
                                .condition = from_top};
  problem.gap += known_gap(pair, instant);
  ArrayXd guess;
  if (condition.penetration == 0.0) {
    guess = -carried_forces(pair, place, last, condition.value).col(kDown);
  } else {
    const double free = condition.coasted + condition.value / condition.penetration;
    const ArrayXd overlap = free - free_gap(pair, instant);
    if (!(overlap > 0.0).any()) return without_contact(overlap.size(), free);
    guess = overlapping_forces(pair, instant, last, overlap, surface.diagonal_compliance());
  }
  PressedNodes contact = solve_elastic_contact(problem, guess, inverse);
  StickSlip result;
  result.force = VectorField::Zero(contact.pressing.size(), 3);
  result.force.col(kDown) = -contact.pressing;
  result.penetration = *contact.penetration - place.top;
  result.nodes = std::move(contact.nodes);
  return result;
}

StickSlip solve_frictional(const ViscoelasticPair& pair, const InstantContact& instant, const LastForces& last,
                           const Departure& departure, const ApproachCondition& condition,
                           const CenterCondition& center, ContactInverse& inverse, ContactStiffness& stiffness) {
  const ContactPlace& place = instant.place;
  // If the load is a result, the contact without friction gives an estimate, from which the search starts.
  double load = condition.value;
  if (condition.penetration != 0.0) {
    StickSlip smooth = solve_frictionless(pair, instant, last, condition, inverse);
    if (smooth.nodes.empty()) return smooth;
    load = -(place.weights * smooth.force.col(kDown)).sum();
  }
  // Penetration from which the search measures: that of an axle without forces, else that at the highest point.
  const bool is_axle = condition.force != 0.0 && condition.penetration != 0.0;
  const double origin = is_axle ? condition.coasted : -place.top;
  ApproachCondition approach = condition;
  approach.coasted = 0.0;
  if (condition.force == 0.0) approach.value -= condition.penetration * origin;
  const SurfaceGrid& grid = pair.nodes.grid;
  const double compliance = instant.instantaneous.sum;
  const ContactPlace before =
      place_of(pair, place.first,
               SurfaceWindow(grid, place.nodes.window(), place.nodes.shift() - departure.turned / grid.phi_spacing),
               place.heights);
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
  const StickSlipProblem problem{
      .surface = surface,
      .gap = place.weights * (place.gap - origin) + known_gap(pair, instant).reshaped().array(),
      .known_slip = std::move(slip.known),
      .slip_per_center_displacement = std::move(slip.slip_per_center_displacement),
      .weights = place.weights,
      .load = load,
      .approach = approach,
      .friction = pair.friction,
      .center_row = row,
      .center_row_needs_displacements = depends_on_displacements(pair, center)};
  StickSlip result = solve_stick_slip(problem, carried_forces(pair, place, last, problem.load), stiffness);
  result.center_displacement += center.coasted;
  result.penetration += origin;
  return result;
}

StickSlip solve_lifted(const ViscoelasticPair& pair, const InstantContact& instant, const CenterCondition& center) {
  StickSlip result = without_contact(instant.place.gap.size(), free_gap(pair, instant).minCoeff());
  result.center_displacement = center.coasted + (center.displacement != 0.0 ? center.value / center.displacement : 0.0);
  return result;
}

double limit_of_touch(const ViscoelasticPair& pair, const InstantContact& instant) {
  const double penetration = instant.contact.penetration;
  const auto& contact = instant.contact.nodes;
  if (approach_exists(pair.pair) || contact.empty()) {
    // The displacement of the surface next to a contact is a small fraction of the indentation.
    constexpr double kMargin = 0.1;
    return penetration + kMargin * std::max(penetration + pair.heights.largest(), 0.0);
  }
  // A half-plane sinks with the logarithm of the distance from the contact, by four times the indentation at 27
  // half-lengths.
  constexpr double kMargin = 4.0;
  const ArrayXd gap = instant.place.gap(contact);
  return gap.maxCoeff() + kMargin * (gap.maxCoeff() - gap.minCoeff());
}

void find_displacements(const ViscoelasticPair& pair, InstantContact& instant) {
  const Index half_nodes = pair.half_nodes();
  const auto& nodes = instant.contact.nodes;
  for (std::size_t b = 0; b < pair.bodies.size(); ++b) {
    const CreepTables& body = pair.bodies[b].tables;
    instant.moved.emplace_back();
    const HalfField pressing = by_components(pair, instant, b);
    for (const MirroredTables& tables : body.all()) {
      instant.moved.back().push_back(nodes.empty()
                                         ? HalfField::Zero(pressing.rows(), instant.place.count + 2 * tables.reach())
                                         : tables.displacement_in_reach(pressing, nodes.front() / half_nodes,
                                                                        nodes.back() / half_nodes, instant.checkpoint));
    }
  }
}

std::vector<HalfField> deformed(const ViscoelasticPair& pair, const InstantContact& instant) {
  std::vector<HalfField> deformed = instant.known;
  for (std::size_t b = 0; b < deformed.size(); ++b) {
    const std::vector<double>& parts = instant.instantaneous.of_bodies[b].parts;
    const Index reach = pair.bodies[b].tables.reach();
    for (std::size_t t = 0; t < parts.size(); ++t) {
      const double share = parts[t] / instant.instantaneous.sum;
      deformed[b] += share * instant.moved[b][t].middleCols(reach, instant.place.count);
    }
  }
  return deformed;
}

RowMemory::Load load_of(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body) {
  const ContactPlace& place = instant.place;
  const CreepTables& tables = pair.bodies[body].tables;
  const Index reach = tables.reach();
  RowMemory::Load load{.first = place.first - reach,
                       .force = HalfField::Zero(tables.height(), place.count + 2 * reach),
                       .displacements = {}};
  for (const HalfField& moved : instant.moved[body]) load.displacements.emplace_back(moved / instant.instantaneous.sum);
  load.force.middleCols(reach, place.count) = by_components(pair, instant, body) / instant.instantaneous.sum;
  return load;
}

double flat_patch(const SurfaceGrid& grid) { return std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing; }

void set_extent(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now) {
  const SurfaceWindow& nodes = instant.place.nodes;
  const ArrayXd& weights = instant.place.weights;
  const ArrayXd forces = -instant.contact.force.col(kDown) / instant.instantaneous.sum;
  now.penetration = instant.contact.penetration;
  now.axle_height = nodes.grid().radius - now.penetration;
  const std::vector<Eigen::Index>& contact = instant.contact.nodes;
  if (!std::isnan(now.penetration)) {
    // Over uneven ground, the deepest point is where the undeformed bodies overlap most.
    const bool is_even = contact.empty() || pair.heights.are_smooth();
    const double highest = is_even ? 0.0 : -instant.place.gap(contact).minCoeff();
    require_depth(pair.pair, now.load, now.penetration + highest);
  }
  const ArrayXd touching = weights(contact).square() * nodes.patch_area(contact);
  const ArrayXd pressure = forces(contact) / weights(contact) / flat_patch(nodes.grid());
  contact_extent(nodes, contact, touching, pressure, 0.0).copy_to(now);
}

CenterPower set_moments(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now) {
  const ArrayXd& weights = instant.place.weights;
  const VectorField force = instant.contact.force.colwise() * weights / instant.instantaneous.sum;
  const std::vector<HalfField> deformed = detail::deformed(pair, instant);
  const ActingPlaces at{pair, instant.place, deformed};
  now.resisting_torque = -(instant.place.moment_arm * force.col(kDown)).sum();
  now.resisting_force = now.resisting_torque / relative_radius(pair.pair);
  now.driving_force = (force_on_center(at) * force).sum();
  now.driving_torque = (moment_about_center(at) * force).sum();
  CenterPower power{.along_track = (force_along_track(at, instant.contact.penetration) * force).sum()};
  if (!pair.has_friction()) return power;
  const VectorField slopes = counterbody_slopes(at);
  if (slopes.rows() > 0) power.creeping = (slopes * force).sum();
  return power;
}

}  // namespace viscoroll::detail
