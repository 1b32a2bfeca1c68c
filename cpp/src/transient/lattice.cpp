#include "transient/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Part of a window that a first guess of the contact takes.
constexpr double kContactShare = 0.8;

/// Steps in which a load rises on a coating with friction.
constexpr int kPressingSteps = 8;

Index on_ring(Index row, Index ring) { return ((row % ring) + ring) % ring; }

/// Numbers of the nodes of a window, row by row, as the columns of a field.
auto as_field(const ArrayXd& values, Index half_nodes) {
  return values.matrix().reshaped(half_nodes, values.size() / half_nodes);
}

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

Lattice::Touch Lattice::touch(const TimeStep* step, double compliance, double angle, double load,
                              double driving_force) {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  // Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
  const Index most = tables.ring() / 6;
  for (;;) {
    Touch touch{.place = place_at(angle), .known = {}, .compliance = compliance, .contact = {}};
    const RingRows& rows = touch.place.rows;
    touch.known =
        step != nullptr ? memory_.known_displacement(*step, rows) : HalfField::Zero(tables.height(), rows.count);
    touch.contact = has_friction()
                        ? touch_with_friction(touch.place, touch.known, compliance, angle, load, driving_force)
                        : touch_smooth(touch.place, touch.known, compliance * load);
    bool at_side = false;
    bool at_end = false;
    for (const Index node : touch.contact.nodes) {
      at_side = at_side || node % half_nodes == half_nodes - 1;
      at_end = at_end || node / half_nodes == 0 || node / half_nodes == rows.count - 1;
    }
    if (at_side) throw ContactTooWide();
    if (!at_end) return touch;
    if (half_rows_ >= most) {
      reject("load", "small enough for the coating", text(load) + " N (it is in contact over 60 degrees to a side)");
    }
    half_rows_ = std::min(half_rows_ + half_rows_ / 2 + 1, most);
    inverse_ = {};
  }
}

StickSlip Lattice::touch_smooth(const Place& place, const HalfField& known, double load) {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  const bool radial = tables.components() == 1;
  const auto& down = place.axes[1];
  const ArrayXd weights = half_weights(half_nodes);
  ElasticContactProblem problem{
      .displacement =
          [&](const HalfField& pressing, Index first, Index last) {
            if (radial) return tables.displacement(pressing, first, last);
            return along(down, tables.displacement(spread(down, pressing), first, last));
          },
      .compliance = [&](const std::vector<Index>& nodes) { return tables.compliance(nodes, down); },
      .gap = weights.matrix().asDiagonal() * as_field(place.nodes.height(), half_nodes),
      .weights = weights.matrix().replicate(1, place.rows.count),
      .load = load,
      .stiffness = 1.0 / tables.block(0)(0, 0)};
  problem.gap += radial ? known : along(down, known);
  const HalfField likely = guess(forces_.pressing, place);
  ElasticContact contact =
      solve_elastic_contact(problem, load / likely.cwiseProduct(problem.weights).sum() * likely, inverse_);
  StickSlip result;
  result.forces.pressing = std::move(contact.pressing);
  result.penetration = contact.penetration;
  result.nodes = std::move(contact.nodes);
  return result;
}

StickSlip Lattice::touch_with_friction(const Place& place, const HalfField& known, double compliance, double angle,
                                       double load, double driving_force) const {
  const Index half_nodes = coating_->tables.half_nodes();
  const SurfaceGrid& grid = coating_->grid;
  const ArrayXd weights = half_weights(half_nodes);
  const SurfaceWindow before(grid, place.nodes.window(), place.nodes.shift() - (angle - now_.angle) / grid.phi_spacing);
  const Axes axes_before = axes_at(before);
  const HalfField borne = memory_.displacement(place.rows);
  const auto weighted = [&](const ArrayXd& values) -> HalfField {
    return weights.matrix().asDiagonal() * as_field(values, half_nodes);
  };
  const StickSlipProblem problem{.tables = coating_->tables,
                                 .axes = place.axes,
                                 .gap = weighted(place.nodes.height()) + along(place.axes[1], known),
                                 .forward_way = weighted(place.nodes.x() - before.x()) - along(place.axes[0], known) +
                                                along(axes_before[0], borne),
                                 .sideways_way = weighted(place.nodes.z() - before.z()) - along(place.axes[2], known) +
                                                 along(axes_before[2], borne),
                                 .weights = weights.matrix().replicate(1, place.rows.count),
                                 .load = compliance * load,
                                 .friction = coating_->friction,
                                 .forward_force = -compliance * driving_force};
  const HalfField likely = guess(forces_.pressing, place);
  return solve_stick_slip(problem, {.pressing = problem.load / likely.cwiseProduct(problem.weights).sum() * likely,
                                    .forward = HalfField::Zero(half_nodes, place.rows.count),
                                    .sideways = HalfField::Zero(half_nodes, place.rows.count)});
}

/// The last pressure, where it has been carried to: it stays below while nodes pass.
HalfField Lattice::guess(const HalfField& last, const Place& place) const {
  const Index half_nodes = coating_->tables.half_nodes();
  if (last.size() == 0) {
    // The window was made a little wider than such a contact.
    const ArrayXd& height = place.nodes.height();
    return as_field((kContactShare * kContactShare * height[0] - height).max(0.0), half_nodes);
  }
  HalfField field = HalfField::Zero(half_nodes, place.rows.count);
  const double lowest = place.nodes.shift() - lowest_ + 0.5 * static_cast<double>(last.cols() - field.cols());
  const auto whole = static_cast<Index>(std::floor(lowest));
  const double share = lowest - static_cast<double>(whole);
  for (Index i = 0; i < field.cols(); ++i) {
    if (i + whole >= 0 && i + whole < last.cols()) field.col(i) += (1.0 - share) * last.col(i + whole);
    if (i + whole + 1 >= 0 && i + whole + 1 < last.cols()) field.col(i) += share * last.col(i + whole + 1);
  }
  return field;
}

RingMemory::Load Lattice::load_of(const Touch& touch) const {
  const MirroredTables& tables = coating_->tables;
  const Place& place = touch.place;
  const PlaneForces& forces = touch.contact.forces;
  HalfField force = forces.pressing / touch.compliance;
  if (has_friction()) {
    force = on_plane(place.axes, forces) / touch.compliance;
  } else if (tables.components() == 3) {
    force = spread(place.axes[1], force);
  }
  const Index reach = tables.reach();
  RingMemory::Load load{
      .rows = {.first = on_ring(place.rows.first - reach, tables.ring()), .count = place.rows.count + 2 * reach},
      .force = HalfField::Zero(tables.height(), place.rows.count + 2 * reach),
      .displacement = tables.displacement_in_reach(force, touch.contact.nodes.front() / tables.half_nodes(),
                                                   touch.contact.nodes.back() / tables.half_nodes())};
  load.force.middleCols(reach, place.rows.count) = force;
  return load;
}

void Lattice::take(const Touch& touch, double angle, double load) {
  now_.angle = angle;
  now_.load = load;
  take_contact(touch);
  now_.driving_torque = now_.resisting_torque;
  if (coating_->tables.components() == 3) take_friction(touch);
  forces_.pressing = touch.contact.forces.pressing / touch.compliance;
  rows_ = touch.place.rows;
  lowest_ = touch.place.nodes.shift();
}

void Lattice::take_contact(const Touch& touch) {
  const Index half_nodes = coating_->tables.half_nodes();
  const SurfaceWindow& nodes = touch.place.nodes;
  const ArrayXd weights = half_weights(half_nodes).matrix().replicate(1, touch.place.rows.count).reshaped();
  const ArrayXd forces = touch.contact.forces.pressing.reshaped().array() / touch.compliance;
  now_.penetration = touch.contact.penetration;
  if (now_.penetration >= coating_->thickness) {
    reject("load", "small enough for the coating",
           text(now_.load) + " N (it is pressed " + rounded(now_.penetration) + " m into a coating of " +
               text(coating_->thickness) + " m)");
  }
  now_.resisting_torque = (weights * nodes.x() * forces).sum();

  const SurfaceGrid& grid = coating_->grid;
  const double flat_patch = std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing;
  const ArrayXd patches = flat_patch * (1.0 - (nodes.z() / grid.radius).square()).sqrt();
  ArrayXd touching = ArrayXd::Zero(forces.size());
  for (const Index node : touch.contact.nodes) touching[node] = weights[node] * weights[node] * patches[node];
  now_.contact_area = touching.sum();
  const double center = (touching * nodes.x()).sum() / now_.contact_area;
  now_.semi_axis_x = 2.0 * std::sqrt((touching * (nodes.x() - center).square()).sum() / now_.contact_area);
  now_.semi_axis_z = 2.0 * std::sqrt((touching * nodes.z().square()).sum() / now_.contact_area);
  now_.max_pressure = (forces / weights).maxCoeff() / flat_patch;
}

/// Forces along the plane act at the height of the center; pressure on undeformed normals does work along the plane.
void Lattice::take_friction(const Touch& touch) {
  const StickSlip& contact = touch.contact;
  const Index half_nodes = coating_->tables.half_nodes();
  if (coating_->compliance == Compliance::vertical) {
    const HalfField force = has_friction() ? on_plane(touch.place.axes, contact.forces)
                                           : spread(touch.place.axes[1], contact.forces.pressing);
    const HalfField moved = touch.known + coating_->tables.displacement(force, contact.nodes.front() / half_nodes,
                                                                        contact.nodes.back() / half_nodes);
    now_.driving_torque -=
        along(touch.place.axes[0], moved).cwiseProduct(contact.forces.pressing).sum() / touch.compliance;
  }
  if (!has_friction()) return;
  const ArrayXd weights = half_weights(half_nodes).matrix().replicate(1, touch.place.rows.count).reshaped();
  now_.driving_force = -(weights * contact.forces.forward.reshaped().array()).sum() / touch.compliance;
  now_.driving_torque -= now_.driving_force * (coating_->grid.radius - contact.penetration);
  now_.center_way += contact.way;
  now_.dissipated_energy += slip_work(touch);
  now_.slip_energy += slip_work(touch);
  now_.stick_share = static_cast<double>(contact.sticking) / static_cast<double>(contact.nodes.size());
  forces_.forward = contact.forces.forward / touch.compliance;
  forces_.sideways = contact.forces.sideways / touch.compliance;
}

/// Energy lost by slip in a step, by the mean of old and new tractions of each node.
double Lattice::slip_work(const Touch& touch) const {
  const StickSlip& contact = touch.contact;
  HalfField forward = contact.forces.forward / touch.compliance;
  HalfField sideways = contact.forces.sideways / touch.compliance;
  for (Index i = 0; i < touch.place.rows.count && forces_.forward.size() > 0; ++i) {
    const Index last = on_ring(touch.place.rows.first + i - rows_.first, coating_->tables.ring());
    if (last >= rows_.count) continue;
    forward.col(i) += forces_.forward.col(last);
    sideways.col(i) += forces_.sideways.col(last);
  }
  return -0.5 * (forward.cwiseProduct(contact.forward_slip) + sideways.cwiseProduct(contact.sideways_slip)).sum();
}

void Lattice::start(Start start, double angle, double load) {
  const bool relaxed = start == Start::relaxed;
  const double compliance = relaxed ? 1.0 : coating_->spectrum.instantaneous;
  now_.angle = angle;
  // With friction, pressing depends on its path: the load rises in steps.
  const int count = has_friction() ? kPressingSteps : 1;
  for (int i = 1; i <= count; ++i) {
    const double borne = load * i / count;
    const Touch contact = touch(nullptr, compliance, angle, borne, 0.0);
    take(contact, angle, borne);
    if (relaxed) {
      memory_.relax(load_of(contact));
    } else {
      memory_.press(load_of(contact));
    }
  }
  now_.stored_energy = memory_.stored_energy();
  now_.dissipated_energy = now_.slip_energy = now_.center_way = 0.0;
}

void Lattice::advance(const TimeStep& step, bool jump, double angle, double load) {
  const RollingInstant before = now_;
  const Touch contact = touch(&step, step.compliance, angle, load, coating_->driving_force);
  take(contact, angle, load);
  const double lost = memory_.advance(step, load_of(contact));
  now_.dissipated_energy += lost;
  now_.stored_energy = memory_.stored_energy();
  const double used = now_.stored_energy - before.stored_energy + now_.dissipated_energy - before.dissipated_energy;
  // A jump is elastic, whatever its way: it takes the energy that it stores.
  const double work = jump
                          ? used
                          : 0.5 * ((before.driving_torque + now_.driving_torque) * (angle - before.angle) +
                                   (before.load + load) * (now_.penetration - before.penetration) +
                                   (before.driving_force + now_.driving_force) * (now_.center_way - before.center_way));
  now_.work += work;
  now_.energy_imbalance += work - used;
}

void Lattice::widen(std::shared_ptr<const CreepingCoating> coating) {
  coating_ = std::move(coating);
  memory_ = memory_.widened(coating_->tables);
  inverse_ = {};
  for (HalfField* field : {&forces_.pressing, &forces_.forward, &forces_.sideways}) {
    HalfField wide = HalfField::Zero(field->size() > 0 ? coating_->tables.half_nodes() : 0, field->cols());
    wide.topRows(field->rows()) = *field;
    *field = std::move(wide);
  }
}

void Lattice::write(NumberWriter& numbers) const {
  for (const auto member : kLatticeScalars) numbers.put(now_.*member);
  numbers.put(static_cast<double>(half_rows_));
  numbers.put(lowest_);
  numbers.put(static_cast<double>(rows_.first));
  numbers.put(static_cast<double>(rows_.count));
  for (const HalfField* field : {&forces_.pressing, &forces_.forward, &forces_.sideways}) numbers.put(*field);
  memory_.write(numbers);
}

void Lattice::read(NumberReader& numbers) {
  for (const auto member : kLatticeScalars) now_.*member = numbers.get();
  half_rows_ = numbers.count(static_cast<double>(coating_->tables.ring()) / 6.0);
  lowest_ = numbers.get();
  rows_ = {.first = numbers.count(static_cast<double>(coating_->tables.ring())), .count = numbers.count()};
  for (HalfField* field : {&forces_.pressing, &forces_.forward, &forces_.sideways}) *field = numbers.matrix();
  memory_ = RingMemory(coating_->tables, coating_->spectrum);
  memory_.read(numbers, coating_->tables);
  inverse_ = {};
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
      field.pressure.push_back(forces_.pressing(std::abs(k), i) / weights[std::abs(k)] / patch);
    }
  }
  return field;
}

}  // namespace viscoroll::detail
