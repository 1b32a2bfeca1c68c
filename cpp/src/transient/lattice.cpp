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

Lattice::Place Lattice::place_at(double angle) const {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  const double lowest = -angle / coating_->grid.phi_spacing - shift_;  // row under the center, not whole
  const double middle = std::round(lowest);
  const auto half_rows = static_cast<int>(half_rows_);
  Place place{
      .rows = {.first = on_ring(static_cast<Index>(std::fmod(middle, static_cast<double>(tables.ring()))) - half_rows_,
                                tables.ring()),
               .count = 2 * half_rows_ + 1},
      .nodes = SurfaceWindow(coating_->grid, {{-half_rows, half_rows}, {0, static_cast<int>(half_nodes) - 1}},
                             middle - lowest),
      .down = {},
      .forward = {}};
  if (tables.components() == 3) {
    const auto axes = place.nodes.axes();
    for (std::size_t component = 0; component < 3; ++component) {
      place.forward[component] = as_field(axes[0][component], half_nodes);
      place.down[component] = as_field(axes[1][component], half_nodes);
    }
  }
  return place;
}

HalfField Lattice::along(const std::array<HalfField, 3>& direction, const HalfField& field) const {
  const Index half_nodes = coating_->tables.half_nodes();
  if (coating_->tables.components() == 1) return field;
  HalfField result = direction[0].cwiseProduct(field.topRows(half_nodes));
  result += direction[1].cwiseProduct(field.middleRows(half_nodes, half_nodes));
  result += direction[2].cwiseProduct(field.bottomRows(half_nodes));
  return result;
}

HalfField Lattice::spread(const std::array<HalfField, 3>& direction, const HalfField& scalar) const {
  if (coating_->tables.components() == 1) return scalar;
  HalfField field(coating_->tables.height(), scalar.cols());
  field << direction[0].cwiseProduct(scalar), direction[1].cwiseProduct(scalar), direction[2].cwiseProduct(scalar);
  return field;
}

ElasticContact Lattice::touch(const Place& place, const HalfField& known, double load) {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  ElasticContactProblem problem{
      .displacement =
          [&](const HalfField& pressing, Index first, Index last) {
            if (tables.components() == 1) return tables.displacement(pressing, first, last);
            return along(place.down, tables.displacement(spread(place.down, pressing), first, last));
          },
      .compliance = [&](const std::vector<Index>& nodes) { return tables.compliance(nodes, place.down); },
      .gap = as_field(place.nodes.height(), half_nodes),
      .weights = {},
      .load = load,
      .stiffness = 1.0 / tables.block(0)(0, 0)};
  const ArrayXd weights = half_weights(half_nodes);
  problem.gap = weights.matrix().asDiagonal() * problem.gap;
  problem.gap += along(place.down, known);
  problem.weights = weights.matrix().replicate(1, place.rows.count);
  return solve_elastic_contact(problem, guess(place, load), inverse_);
}

/// The last pressure, where it has been carried to: it stays below while nodes pass.
HalfField Lattice::guess(const Place& place, double load) const {
  const Index half_nodes = coating_->tables.half_nodes();
  HalfField field = HalfField::Zero(half_nodes, place.rows.count);
  if (pressing_.size() == 0) {
    // The window was made a little wider than such a contact.
    const ArrayXd& height = place.nodes.height();
    const double rim = kContactShare * kContactShare * height[0];
    field = as_field((rim - height).max(0.0), half_nodes);
    return load / field.sum() * field;
  }
  const double lowest = place.nodes.shift() - lowest_ + static_cast<double>((pressing_.cols() - field.cols()) / 2);
  const auto whole = static_cast<Index>(std::floor(lowest));
  const double share = lowest - static_cast<double>(whole);
  for (Index i = 0; i < field.cols(); ++i) {
    if (i + whole >= 0 && i + whole < pressing_.cols()) field.col(i) += (1.0 - share) * pressing_.col(i + whole);
    if (i + whole + 1 >= 0 && i + whole + 1 < pressing_.cols()) field.col(i) += share * pressing_.col(i + whole + 1);
  }
  return load * field;
}

RingMemory::Load Lattice::load_of(const Place& place, const ElasticContact& contact, double compliance) const {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  const HalfField force = spread(place.down, contact.pressing / compliance);
  const Index reach = tables.reach();
  RingMemory::Load load{
      .rows = {.first = on_ring(place.rows.first - reach, tables.ring()), .count = place.rows.count + 2 * reach},
      .force = HalfField::Zero(tables.height(), place.rows.count + 2 * reach),
      .displacement =
          tables.displacement_in_reach(force, contact.nodes.front() / half_nodes, contact.nodes.back() / half_nodes)};
  load.force.middleCols(reach, place.rows.count) = force;
  return load;
}

ElasticContact Lattice::touch_in_window(const TimeStep* step, double compliance, double angle, double load,
                                        Place& place) {
  const Index half_nodes = coating_->tables.half_nodes();
  // Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
  const Index most = coating_->tables.ring() / 6;
  for (;;) {
    place = place_at(angle);
    const HalfField known = step != nullptr ? memory_.known_displacement(*step, place.rows)
                                            : HalfField::Zero(coating_->tables.height(), place.rows.count);
    ElasticContact contact = touch(place, known, compliance * load);
    const Index last = place.rows.count - 1;
    bool at_side = false;
    bool at_end = false;
    for (const Index node : contact.nodes) {
      at_side = at_side || node % half_nodes == half_nodes - 1;
      at_end = at_end || node / half_nodes == 0 || node / half_nodes == last;
    }
    if (at_side) throw ContactTooWide();
    if (!at_end) {
      take(place, contact, known, compliance, angle, load);
      return contact;
    }
    if (half_rows_ >= most) {
      reject("load", "small enough for the coating", text(load) + " N (it is in contact over 60 degrees to a side)");
    }
    half_rows_ = std::min(half_rows_ + half_rows_ / 2 + 1, most);
    inverse_ = {};
  }
}

void Lattice::take(const Place& place, const ElasticContact& contact, const HalfField& known, double compliance,
                   double angle, double load) {
  const MirroredTables& tables = coating_->tables;
  const Index half_nodes = tables.half_nodes();
  const ArrayXd weights = half_weights(half_nodes).matrix().replicate(1, place.rows.count).reshaped();
  const ArrayXd forces = contact.pressing.reshaped().array() / compliance;
  now_.angle = angle;
  now_.load = load;
  now_.penetration = contact.penetration;
  if (now_.penetration >= coating_->thickness) {
    reject("load", "small enough for the coating",
           text(load) + " N (it is pressed " + rounded(now_.penetration) + " m into a coating of " +
               text(coating_->thickness) + " m)");
  }
  now_.resisting_torque = (weights * place.nodes.x() * forces).sum();
  now_.driving_torque = now_.resisting_torque;
  if (tables.components() == 3) {
    // Pressure on undeformed normals does work along the plane, too.
    const HalfField moved =
        known + tables.displacement(spread(place.down, contact.pressing), contact.nodes.front() / half_nodes,
                                    contact.nodes.back() / half_nodes);
    now_.driving_torque -= along(place.forward, moved).cwiseProduct(contact.pressing).sum() / compliance;
  }

  const SurfaceGrid& grid = coating_->grid;
  const ArrayXd patches = std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing *
                          (1.0 - (place.nodes.z() / grid.radius).square()).sqrt();
  ArrayXd touching = ArrayXd::Zero(forces.size());
  for (const Index node : contact.nodes) touching[node] = weights[node] * weights[node] * patches[node];
  now_.contact_area = touching.sum();
  const double center = (touching * place.nodes.x()).sum() / now_.contact_area;
  now_.semi_axis_x = 2.0 * std::sqrt((touching * (place.nodes.x() - center).square()).sum() / now_.contact_area);
  now_.semi_axis_z = 2.0 * std::sqrt((touching * place.nodes.z().square()).sum() / now_.contact_area);
  now_.max_pressure =
      (forces / weights).maxCoeff() / (std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing);
  pressing_ = contact.pressing / (compliance * load);
  lowest_ = place.nodes.shift();
}

void Lattice::start(Start start, double angle, double load) {
  const double compliance = start == Start::relaxed ? 1.0 : coating_->spectrum.instantaneous;
  Place place = place_at(angle);
  const ElasticContact contact = touch_in_window(nullptr, compliance, angle, load, place);
  const RingMemory::Load borne = load_of(place, contact, compliance);
  if (start == Start::relaxed) {
    memory_.relax(borne);
  } else {
    memory_.press(borne);
  }
  now_.stored_energy = memory_.stored_energy();
}

void Lattice::advance(const TimeStep& step, bool jump, double angle, double load) {
  const RollingInstant before = now_;
  Place place = place_at(angle);
  const ElasticContact contact = touch_in_window(&step, step.compliance, angle, load, place);
  const double lost = memory_.advance(step, load_of(place, contact, step.compliance));
  now_.stored_energy = memory_.stored_energy();
  const double stored = now_.stored_energy - before.stored_energy;
  // A jump is elastic, whatever its way: it takes the energy that it stores.
  const double work = jump ? stored
                           : 0.5 * ((before.driving_torque + now_.driving_torque) * (angle - before.angle) +
                                    (before.load + load) * (now_.penetration - before.penetration));
  now_.dissipated_energy += lost;
  now_.work += work;
  now_.energy_imbalance += work - stored - lost;
}

void Lattice::widen(std::shared_ptr<const CreepingCoating> coating) {
  coating_ = std::move(coating);
  memory_ = memory_.widened(coating_->tables);
  inverse_ = {};
  pressing_ = HalfField();
}

namespace {

constexpr std::array kInstant{&RollingInstant::angle,
                              &RollingInstant::load,
                              &RollingInstant::resisting_torque,
                              &RollingInstant::driving_torque,
                              &RollingInstant::penetration,
                              &RollingInstant::contact_area,
                              &RollingInstant::semi_axis_x,
                              &RollingInstant::semi_axis_z,
                              &RollingInstant::max_pressure,
                              &RollingInstant::stored_energy,
                              &RollingInstant::dissipated_energy,
                              &RollingInstant::work,
                              &RollingInstant::energy_imbalance};

}  // namespace

void Lattice::write(NumberWriter& numbers) const {
  for (const auto member : kInstant) numbers.put(now_.*member);
  numbers.put(static_cast<double>(half_rows_));
  numbers.put(lowest_);
  numbers.put(pressing_);
  memory_.write(numbers);
}

void Lattice::read(NumberReader& numbers) {
  for (const auto member : kInstant) now_.*member = numbers.get();
  half_rows_ = numbers.count(static_cast<double>(coating_->tables.ring()) / 6.0);
  lowest_ = numbers.get();
  pressing_ = numbers.matrix();
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
      field.pressure.push_back(now_.load * pressing_(std::abs(k), i) / weights[std::abs(k)] / patch);
    }
  }
  return field;
}

}  // namespace viscoroll::detail
