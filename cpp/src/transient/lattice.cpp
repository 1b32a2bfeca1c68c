#include "transient/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/contact_extent.hpp"
#include "contact/lever_arms.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Part of a window that a first guess of the contact takes.
constexpr double kContactShare = 0.8;

/// Forces as saved states have them: pressing, forward, sideways.
constexpr std::array<std::pair<Axis, double>, 3> kSaved{{{kDown, -1.0}, {kForward, 1.0}, {kSideways, 1.0}}};

/// Steps in which a load rises on a coating with friction.
constexpr int kPressingSteps = 8;

Index on_ring(Index row, Index ring) { return ((row % ring) + ring) % ring; }

}  // namespace

Lattice::Lattice(std::shared_ptr<const CreepingCoating> coating, double shift, Index half_rows)
    : coating_(std::move(coating)),
      shift_(shift),
      half_rows_(half_rows),
      memory_(coating_->tables, coating_->spectrum) {}

Axes Lattice::axes_at(const SurfaceWindow& nodes) const {
  const Index half_nodes = coating_->tables.half_nodes();
  Axes axes;
  if (coating_->tables.components() == 1) return axes;
  const auto exact = nodes.axes();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t component = 0; component < 3; ++component) {
      axes[axis][component] = as_field(exact[axis][component], half_nodes);
    }
  }
  if (coating_->compliance == Compliance::vertical) return axes;
  // As at the lowest point, but that forces along the plane press with their share of r, and u_r moves the surface
  // along the plane: theory.md section 6.
  const HalfField one = HalfField::Ones(half_nodes, axes[0][0].cols());
  const HalfField none = HalfField::Zero(half_nodes, axes[0][0].cols());
  return {{{axes[0][0], -one, none}, {one, none, none}, {axes[2][0], none, -one}}};
}

Lattice::Place Lattice::place_at(double angle) const {
  const MirroredTables& tables = coating_->tables;
  const double lowest = -angle / coating_->grid.phi_spacing - shift_;  // row under the center, not whole
  const double middle = std::round(lowest);
  const auto half_rows = static_cast<int>(half_rows_);
  const SurfaceWindow nodes(coating_->grid, {{-half_rows, half_rows}, {0, static_cast<int>(tables.half_nodes()) - 1}},
                            middle - lowest);
  const auto first = static_cast<Index>(std::fmod(middle, static_cast<double>(tables.ring()))) - half_rows_;
  return {.rows = {.first = on_ring(first, tables.ring()), .count = 2 * half_rows_ + 1},
          .nodes = nodes,
          .axes = axes_at(nodes)};
}

/// Without mass the center goes where forces balance. With it, by the method of J. Chung and G. M. Hulbert, J. Appl.
/// Mech. 60 (1993) 371-375, at spectral radius 0: exact where the force is constant, and what swings faster than the
/// steps is gone after two of them. The trapezoidal rule would ring.
CenterCondition Lattice::center_condition(double duration, const StepEnd& end) const {
  if (end.center_way) return {.force = 0.0, .way = 1.0, .value = *end.center_way - now_.center_way};
  const double mass = coating_->mass;
  if (mass == 0.0) return {.force = 1.0, .way = 0.0, .value = -coating_->driving_force};
  if (duration == 0.0) return {.force = 0.0, .way = 1.0, .value = 0.0};
  return {.force = 1.0,
          .way = -2.0 * mass / (duration * duration),
          .value = -coating_->driving_force - 2.0 * mass * now_.center_speed / duration};
}

void Lattice::move_center(double duration, double way) {
  now_.center_way += way;
  if (duration == 0.0) return;
  const double mean_speed = way / duration;
  const double before = center_acceleration_;
  if (coating_->mass == 0.0) {
    now_.center_speed = mean_speed;
    return;
  }
  center_acceleration_ = (mean_speed - now_.center_speed) / duration + 0.5 * before;
  now_.center_speed += duration * (1.5 * center_acceleration_ - 0.5 * before);
}

Lattice::Touch Lattice::touch(const TimeStep* step, double compliance, const StepEnd& end,
                              const CenterCondition& center) {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  const Index most = nodes_to_60_degrees(tables.ring());
  for (;;) {
    Touch touch{.place = place_at(end.angle), .known = {}, .compliance = compliance, .contact = {}};
    const RingRows& rows = touch.place.rows;
    touch.known =
        step != nullptr ? memory_.known_displacement(*step, rows) : HalfField::Zero(tables.height(), rows.count);
    if (end.load == 0.0) {
      touch.contact = lifted(touch.place, touch.known, center);
      return touch;
    }
    touch.contact = has_friction() ? touch_with_friction(touch.place, touch.known, compliance, end, center)
                                   : touch_smooth(touch.place, touch.known, compliance * end.load);
    bool at_side = false;
    bool at_end = false;
    for (const Index node : touch.contact.nodes) {
      at_side = at_side || node % half_nodes == half_nodes - 1;
      at_end = at_end || node / half_nodes == 0 || node / half_nodes == rows.count - 1;
    }
    if (at_side) throw ContactTooWide();
    if (!at_end) return touch;
    if (half_rows_ >= most) {
      reject("load", "small enough for the coating",
             text(end.load) + " N (it is in contact over 60 degrees to a side)");
    }
    half_rows_ = std::min(half_rows_ + half_rows_ / 2 + 1, most);
    forget_contact();
  }
}

StickSlip Lattice::touch_smooth(const Place& place, const HalfField& known, double load) {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  const auto& down = place.axes[kDown];
  const ArrayXd weights = half_weights(half_nodes);
  ElasticContactProblem problem{.tables = tables,
                                .down = down,
                                .gap = weights.matrix().asDiagonal() * as_field(place.nodes.height(), half_nodes),
                                .weights = weights.matrix().replicate(1, place.rows.count),
                                .load = load};
  problem.gap += tables.components() == 1 ? known : along(down, known);
  PressedNodes contact = solve_elastic_contact(problem, -guess(place, load).col(kDown), inverse_);
  StickSlip result;
  result.force = VectorField::Zero(contact.pressing.size(), 3);
  result.force.col(kDown) = -contact.pressing;
  result.penetration = *contact.penetration;
  result.displacement = tables.displacement_in_reach(
      by_components(result.force, place), contact.nodes.front() / half_nodes, contact.nodes.back() / half_nodes);
  result.nodes = std::move(contact.nodes);
  return result;
}

/// The plane just touches what the coating remembers, and bears nothing.
StickSlip Lattice::lifted(const Place& place, const HalfField& known, const CenterCondition& center) const {
  const Index half_nodes = coating_->tables.half_nodes();
  const HalfField weights = half_weights(half_nodes).matrix().replicate(1, place.rows.count);
  const HalfField rise = coating_->tables.components() == 1 ? known : along(place.axes[1], known);
  StickSlip result;
  result.force = VectorField::Zero(weights.size(), 3);
  result.penetration = (as_field(place.nodes.height(), half_nodes) + rise.cwiseQuotient(weights)).minCoeff();
  result.way = center.way != 0.0 ? center.value / center.way : 0.0;
  result.slip = Eigen::ArrayX2d::Zero(weights.size(), 2);
  result.displacement = HalfField::Zero(coating_->tables.height(), place.rows.count + 2 * coating_->tables.reach());
  return result;
}

StickSlip Lattice::touch_with_friction(const Place& place, const HalfField& known, double compliance,
                                       const StepEnd& end, const CenterCondition& center) {
  const SurfaceGrid& grid = coating_->grid;
  const ArrayXd weights = half_weights(coating_->tables.half_nodes()).replicate(place.rows.count, 1);
  const SurfaceWindow before(grid, place.nodes.window(),
                             place.nodes.shift() - (end.angle - now_.angle) / grid.phi_spacing);
  const Axes axes_before = axes_at(before);
  const HalfField borne = memory_.displacement(place.rows);
  const auto part = [](const Axes& axes, std::size_t axis, const HalfField& field) -> ArrayXd {
    return along(axes[axis], field).reshaped();
  };
  const StickSlipProblem problem{
      .tables = coating_->tables,
      .axes = place.axes,
      .gap = weights * place.nodes.height() + part(place.axes, kDown, known),
      .forward_way = weights * (place.nodes.x() - before.x()) - part(place.axes, kForward, known) +
                     part(axes_before, kForward, borne),
      .sideways_way = weights * (place.nodes.z() - before.z()) - part(place.axes, kSideways, known) +
                      part(axes_before, kSideways, borne),
      .weights = weights,
      .load = compliance * end.load,
      .friction = coating_->friction,
      .center = {.force = center.force, .way = compliance * center.way, .value = compliance * center.value}};
  return solve_stick_slip(problem, guess(place, problem.load), stiffness_);
}

/// Forces of the last window, where they have been carried to: they stay below while nodes pass.
VectorField Lattice::carried_forces(const Place& place) const {
  const Index half_nodes = coating_->tables.half_nodes();
  VectorField force = VectorField::Zero(half_nodes * place.rows.count, 3);
  const double lowest = place.nodes.shift() - lowest_ + 0.5 * static_cast<double>(rows_.count - place.rows.count);
  const auto whole = static_cast<Index>(std::floor(lowest));
  const double ahead = lowest - static_cast<double>(whole);
  const auto add = [&](Index row, Index last, double share) {
    if (last < 0 || last >= rows_.count) return;
    force.middleRows(half_nodes * row, half_nodes) += share * force_.middleRows(half_nodes * last, half_nodes);
  };
  for (Index row = 0; row < place.rows.count; ++row) {
    add(row, row + whole, 1.0 - ahead);
    add(row, row + whole + 1, ahead);
  }
  return force;
}

/// The last forces for a new load, or those of a first contact, which the window was made a little wider than.
VectorField Lattice::guess(const Place& place, double load) const {
  VectorField guess = carried_forces(place);
  if (!(guess.col(kDown) < 0.0).any()) {
    const ArrayXd& height = place.nodes.height();
    guess.col(kDown) = -(kContactShare * kContactShare * height[0] - height).max(0.0);
  }
  const ArrayXd weights = half_weights(coating_->tables.half_nodes()).replicate(place.rows.count, 1);
  return load / -(weights * guess.col(kDown)).sum() * guess;
}

/// What the plane does to the coating.
HalfField Lattice::by_components(const VectorField& force, const Place& place) const {
  const MirroredTables& tables = coating_->tables;
  return tables.components() == 1 ? as_field(-force.col(kDown), tables.half_nodes()) : on_plane(place.axes, force);
}

void Lattice::forget_contact() {
  inverse_ = {};
  stiffness_ = {};
}

RingMemory::Load Lattice::load_of(const Touch& touch) const {
  const MirroredTables& tables = coating_->tables;
  const RingRows& rows = touch.place.rows;
  const Index reach = tables.reach();
  RingMemory::Load load{.rows = {.first = on_ring(rows.first - reach, tables.ring()), .count = rows.count + 2 * reach},
                        .force = HalfField::Zero(tables.height(), rows.count + 2 * reach),
                        .displacement = touch.contact.displacement / touch.compliance};
  load.force.middleCols(reach, rows.count) = by_components(touch.contact.force, touch.place) / touch.compliance;
  return load;
}

void Lattice::take(const Touch& touch, const StepEnd& end) {
  now_.angle = end.angle;
  now_.load = end.load;
  take_contact(touch);
  take_moments(touch);
  if (has_friction()) take_friction(touch);
  force_ = touch.contact.force / touch.compliance;
  rows_ = touch.place.rows;
  lowest_ = touch.place.nodes.shift();
}

void Lattice::take_contact(const Touch& touch) {
  const Index half_nodes = coating_->tables.half_nodes();
  const SurfaceWindow& nodes = touch.place.nodes;
  const ArrayXd weights = half_weights(half_nodes).matrix().replicate(1, touch.place.rows.count).reshaped();
  const ArrayXd forces = -touch.contact.force.col(kDown) / touch.compliance;
  now_.penetration = touch.contact.penetration;
  if (now_.penetration >= coating_->thickness) {
    reject("load", "small enough for the coating",
           text(now_.load) + " N (it is pressed " + rounded(now_.penetration) + " m into a coating of " +
               text(coating_->thickness) + " m)");
  }

  const SurfaceGrid& grid = coating_->grid;
  const double flat_patch = std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing;
  const ArrayXd patches = flat_patch * (1.0 - (nodes.z() / grid.radius).square()).sqrt();
  ArrayXd touching = ArrayXd::Zero(forces.size());
  for (const Index node : touch.contact.nodes) touching[node] = weights[node] * weights[node] * patches[node];
  const ContactExtent extent = contact_extent(nodes, touching, 0.0);
  now_.contact_area = extent.area;
  now_.semi_axis_x = extent.semi_axis_x;
  now_.semi_axis_z = extent.semi_axis_z.value();
  now_.max_pressure = (forces / weights).maxCoeff() / flat_patch;
}

/// About the center. Pressure works along the plane where it moves what it stands on along it.
void Lattice::take_moments(const Touch& touch) {
  const SurfaceWindow& nodes = touch.place.nodes;
  const ArrayXd weights =
      half_weights(coating_->tables.half_nodes()).matrix().replicate(1, touch.place.rows.count).reshaped();
  const double radius = coating_->grid.radius;
  LeverArms arms{
      .x = nodes.x(), .y = ArrayXd::Constant(weights.size(), radius - touch.contact.penetration), .radius = radius};
  const VectorField force = touch.contact.force.colwise() * weights / touch.compliance;
  now_.resisting_torque = -(arms.x * force.col(kDown)).sum();
  if (coating_->compliance == Compliance::vertical) {
    const HalfField moved =
        touch.known + touch.contact.displacement.middleCols(coating_->tables.reach(), touch.place.rows.count);
    arms.x -= along(touch.place.axes[kForward], moved).reshaped().array() / weights;
  }
  if (has_friction()) now_.driving_force = -force.col(kForward).sum();
  now_.driving_torque = moment(arms, force);
}

void Lattice::take_friction(const Touch& touch) {
  const StickSlip& contact = touch.contact;
  const double lost = slip_work(touch);
  now_.dissipated_energy += lost;
  now_.slip_energy += lost;
  now_.stick_share = static_cast<double>(contact.sticking) / std::max(1.0, static_cast<double>(contact.nodes.size()));
}

/// Energy lost by slip in a step, by the mean of old and new tractions of each node.
double Lattice::slip_work(const Touch& touch) const {
  const Index half_nodes = coating_->tables.half_nodes();
  VectorField force = touch.contact.force / touch.compliance;
  for (Index row = 0; row < touch.place.rows.count; ++row) {
    const Index last = on_ring(touch.place.rows.first + row - rows_.first, coating_->tables.ring());
    if (last >= rows_.count) continue;
    force.middleRows(half_nodes * row, half_nodes) += force_.middleRows(half_nodes * last, half_nodes);
  }
  const auto& slip = touch.contact.slip;
  return -0.5 * (force.col(kForward) * slip.col(0) + force.col(kSideways) * slip.col(1)).sum();
}

void Lattice::start(Start start, const StepEnd& at, double center_speed) {
  const bool relaxed = start == Start::relaxed;
  const double compliance = relaxed ? 1.0 : coating_->spectrum.instantaneous;
  now_.angle = at.angle;
  // With friction, pressing depends on its path: the load rises in steps, without a force on the center.
  const int count = has_friction() ? kPressingSteps : 1;
  for (int i = 1; i <= count; ++i) {
    StepEnd end = at;
    end.load *= static_cast<double>(i) / count;
    const Touch contact = touch(nullptr, compliance, end, {});
    take(contact, end);
    if (relaxed) {
      memory_.relax(load_of(contact));
    } else {
      memory_.press(load_of(contact));
    }
  }
  now_.stored_energy = memory_.stored_energy();
  now_.dissipated_energy = now_.slip_energy = 0.0;
  now_.center_speed = center_speed;
}

void Lattice::advance(const TimeStep& step, double duration, const StepEnd& end) {
  const RollingInstant before = now_;
  const Touch contact = touch(&step, step.compliance, end, center_condition(duration, end));
  take(contact, end);
  if (has_friction()) move_center(duration, contact.contact.way);
  const double lost = memory_.advance(step, load_of(contact));
  now_.dissipated_energy += lost;
  now_.stored_energy = memory_.stored_energy();
  const double used = now_.stored_energy - before.stored_energy + now_.dissipated_energy - before.dissipated_energy;
  // A jump is elastic, whatever its way: it takes the energy that it stores.
  const double work = duration == 0.0
                          ? used
                          : 0.5 * ((before.driving_torque + now_.driving_torque) * (end.angle - before.angle) +
                                   (before.load + end.load) * (now_.penetration - before.penetration) +
                                   (before.driving_force + now_.driving_force) * (now_.center_way - before.center_way));
  now_.work += work;
  now_.energy_imbalance += work - used;
}

void Lattice::widen(std::shared_ptr<const CreepingCoating> coating) {
  coating_ = std::move(coating);
  memory_ = memory_.widened(coating_->tables);
  forget_contact();
  const Index half_nodes = coating_->tables.half_nodes();
  const Index before = force_.rows() / std::max<Index>(rows_.count, 1);
  VectorField wide = VectorField::Zero(half_nodes * rows_.count, 3);
  for (Index row = 0; row < rows_.count; ++row) {
    wide.middleRows(half_nodes * row, before) = force_.middleRows(before * row, before);
  }
  force_ = std::move(wide);
}

void Lattice::write(NumberWriter& numbers) const {
  for (const auto member : kLatticeScalars) numbers.put(now_.*member);
  numbers.put(center_acceleration_);
  numbers.put(static_cast<double>(half_rows_));
  numbers.put(lowest_);
  numbers.put(static_cast<double>(rows_.first));
  numbers.put(static_cast<double>(rows_.count));
  for (const auto& [axis, sign] : kSaved) {
    numbers.put(as_field(sign * force_.col(axis), coating_->tables.half_nodes()));
  }
  memory_.write(numbers);
}

void Lattice::read(NumberReader& numbers) {
  for (const auto member : kLatticeScalars) now_.*member = numbers.get();
  center_acceleration_ = numbers.get();
  half_rows_ = numbers.count(static_cast<double>(nodes_to_60_degrees(coating_->tables.ring())));
  lowest_ = numbers.get();
  rows_ = {.first = numbers.count(static_cast<double>(coating_->tables.ring())), .count = numbers.count()};
  force_ = VectorField::Zero(coating_->tables.half_nodes() * rows_.count, 3);
  for (const auto& [axis, sign] : kSaved) {
    const HalfField field = numbers.matrix();
    if (field.size() == force_.rows()) force_.col(axis) = sign * field.reshaped();
  }
  memory_ = RingMemory(coating_->tables, coating_->spectrum);
  memory_.read(numbers, coating_->tables);
  forget_contact();
}

ContactField Lattice::field() const {
  const Place place = place_at(now_.angle);
  const Index half_nodes = coating_->tables.half_nodes();
  const Index sides = 2 * half_nodes - 1;
  const SurfaceGrid& grid = coating_->grid;
  const double patch = std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing;
  const ArrayXd weights = half_weights(half_nodes);
  ContactField field{.phi_nodes = static_cast<int>(place.rows.count), .theta_nodes = static_cast<int>(sides)};
  for (Index i = 0; i < place.rows.count; ++i) {
    for (Index k = 1 - half_nodes; k < half_nodes; ++k) {
      const Index node = i * half_nodes + std::abs(k);
      field.x.push_back(place.nodes.x()[node]);
      field.z.push_back(k < 0 ? -place.nodes.z()[node] : place.nodes.z()[node]);
      field.pressure.push_back(-force_(node, kDown) / weights[std::abs(k)] / patch);
    }
  }
  return field;
}

}  // namespace viscoroll::detail
