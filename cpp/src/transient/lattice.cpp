#include "transient/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "contact/contact_extent.hpp"
#include "contact/lever_arms.hpp"
#include "surface/patch_slope.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Forces as saved states have them: pressing, forward, sideways.
constexpr std::array<std::pair<Axis, double>, 3> kSaved{{{kDown, -1.0}, {kForward, 1.0}, {kSideways, 1.0}}};

/// Steps in which a load rises on a coating with friction.
constexpr int kPressingSteps = 8;

/// Parts that have yielded after steps whose durations differ by the round-off of their times.
bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kRoundOff = 1e-10;
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= kRoundOff * std::abs(x); });
}

double flat_patch(const SurfaceGrid& grid) { return std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing; }

}  // namespace

Lattice::Lattice(std::shared_ptr<const CreepingPair> pair, double shift, Index half_rows)
    : pair_(std::move(pair)), shift_(shift), half_rows_(half_rows) {
  for (const CreepingBody& body : pair_->bodies) memories_.emplace_back(body);
}

/// Tables that are sums serve on while steps take as long.
template <class Parts>
Lattice::Yielding Lattice::yielding(const Parts& parts_in) {
  last_.resize(pair_->bodies.size());
  Yielding yielding{.of_bodies = {}, .sum = 0.0};
  for (std::size_t b = 0; b < last_.size(); ++b) {
    const CreepingTables& tables = pair_->bodies[b].tables;
    std::vector<double> parts = parts_in(b);
    if (tables.count() == 1 || !are_same(parts, last_[b].parts)) {
      last_[b] = tables.yielding(std::move(parts));
      if (tables.count() > 1) stiffness_ = {};
    }
    yielding.sum += last_[b].share;
  }
  yielding.of_bodies = last_;
  return yielding;
}

Lattice::Touch Lattice::touch(const PairStep* step, const Yielding& yielding, const StepEnd& end,
                              const CenterCondition& center) {
  for (;;) {
    Touch touch{.place = place_at(*pair_, shift_, half_rows_, end.angle),
                .yielding = yielding,
                .known = {},
                .contact = {},
                .moved = {}};
    require_reach(touch.place);
    const auto& [first, count] = std::pair(touch.place.first, touch.place.count);
    for (std::size_t b = 0; b < memories_.size(); ++b) {
      const Index height = pair_->bodies[b].tables.height();
      touch.known.push_back(step != nullptr ? memories_[b].known_displacement(step->parts[b], first, count)
                                            : HalfField::Zero(height, count));
    }
    if (end.load == 0.0) {
      touch.contact = lifted(touch, center);
    } else {
      require_open_track(touch.place);
      touch.contact =
          has_friction() ? touch_with_friction(touch, end, center) : touch_smooth(touch, yielding.sum * end.load);
      if (!fits(touch, end.load)) continue;
    }
    find_displacements(touch);
    return touch;
  }
}

/// Where displacements do not die out, as those of a half-space, all that a track remembers displaces the contact.
void Lattice::require_reach(const ContactPlace& place) const {
  if (pair_->track_reach >= pair_->most_track_reach()) return;
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    const CreepingTables& tables = pair_->bodies[b].tables;
    const auto alive = memories_[b].living();
    if (!alive || tables.dies_out()) continue;
    const Index farthest = std::max(place.first + place.count - 1 - alive->first, alive->last - place.first);
    if (farthest > tables.reach()) throw TrackTooLong();
  }
}

/// A dish or a ring closes on itself, which the rows of a track do not know: what it remembers is not met from behind.
void Lattice::require_open_track(const ContactPlace& place) const {
  const double turning = std::abs(pair_->pair.on.curvatures.along);
  if (turning == 0.0) return;
  const double spacing = pair_->nodes.grid.radius * pair_->nodes.grid.phi_spacing;
  const double around = 2.0 * std::numbers::pi / turning;
  for (const RowMemory& memory : memories_) {
    const auto alive = memory.living();
    if (!alive) continue;
    const Index rows = std::max(place.first + place.count - 1, alive->last) - std::min(place.first, alive->first) + 1;
    const double way = spacing * static_cast<double>(rows);
    if (way <= around) continue;
    reject("way", "less than once around what it rolls on, " + rounded(around) + " m, while its track remembers",
           rounded(way) + " m");
  }
}

/// Whether the contact ends within the window, which is made wider where it does not.
bool Lattice::fits(const Touch& touch, double load) {
  const Index half_nodes = pair_->half_nodes();
  const Index most = pair_->nodes.widest.phi.last;
  bool at_side = false;
  bool at_end = false;
  for (const Index node : touch.contact.nodes) {
    at_side = at_side || node % half_nodes == half_nodes - 1;
    at_end = at_end || node / half_nodes == 0 || node / half_nodes == touch.place.count - 1;
  }
  if (at_side && !pair_->ends_at_sides()) throw ContactTooWide();
  if (!at_end) return true;
  if (half_rows_ >= most) {
    reject("load", "small enough for the coating",
           text(load) + " " + std::string(pair_->pair.body.form.load_unit) +
               " (it is in contact over 60 degrees to a side)");
  }
  half_rows_ = std::min(half_rows_ + half_rows_ / 2 + 1, most);
  forget_contact();
  return false;
}

void Lattice::find_displacements(Touch& touch) const {
  if (has_friction() && !touch.contact.nodes.empty() && coating().count() == 1) {
    touch.moved.push_back({std::move(touch.contact.displacement)});
    return;
  }
  const Index half_nodes = pair_->half_nodes();
  const HalfField pressing = by_components(touch.contact.force, touch.place);
  const auto& nodes = touch.contact.nodes;
  for (const CreepingBody& body : pair_->bodies) {
    touch.moved.emplace_back();
    for (const MirroredTables& tables : body.tables.all()) {
      touch.moved.back().push_back(
          nodes.empty()
              ? HalfField::Zero(pressing.rows(), touch.place.count + 2 * tables.reach())
              : tables.displacement_in_reach(pressing, nodes.front() / half_nodes, nodes.back() / half_nodes));
    }
  }
}

/// What both bodies remember opens the gap.
HalfField Lattice::known_gap(const Touch& touch) const {
  HalfField known = touch.known.front();
  for (std::size_t b = 1; b < touch.known.size(); ++b) known += touch.known[b];
  return coating().components() == 1 ? known : along(touch.place.axes[kDown], known);
}

StickSlip Lattice::touch_smooth(const Touch& touch, double load) {
  const Index half_nodes = pair_->half_nodes();
  const ArrayXd weights = half_weights(half_nodes);
  std::vector<StepOperator::Part> parts;
  parts.reserve(memories_.size());
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    const YieldingTables& body = touch.yielding.of_bodies[b];
    parts.push_back({body.share / touch.yielding.sum, body.tables.get()});
  }
  const StepOperator surface(std::move(parts));
  ElasticContactProblem problem{.surface = surface,
                                .down = touch.place.axes[kDown],
                                .gap = weights.matrix().asDiagonal() * as_field(touch.place.gap, half_nodes),
                                .weights = weights.matrix().replicate(1, touch.place.count),
                                .load = load};
  problem.gap += known_gap(touch);
  PressedNodes contact =
      solve_elastic_contact(problem, -carried_forces(*pair_, touch.place, last_forces(), load).col(kDown), inverse_);
  StickSlip result;
  result.force = VectorField::Zero(contact.pressing.size(), 3);
  result.force.col(kDown) = -contact.pressing;
  result.penetration = *contact.penetration;
  result.nodes = std::move(contact.nodes);
  return result;
}

/// The bodies just touch with what they remember, and bear nothing.
StickSlip Lattice::lifted(const Touch& touch, const CenterCondition& center) const {
  const Index half_nodes = pair_->half_nodes();
  const HalfField weights = half_weights(half_nodes).matrix().replicate(1, touch.place.count);
  StickSlip result;
  result.force = VectorField::Zero(weights.size(), 3);
  result.penetration = (as_field(touch.place.gap, half_nodes) + known_gap(touch).cwiseQuotient(weights)).minCoeff();
  result.way = center.way != 0.0 ? center.value / center.way : 0.0;
  result.slip = Eigen::ArrayX2d::Zero(weights.size(), 2);
  return result;
}

StickSlip Lattice::touch_with_friction(const Touch& touch, const StepEnd& end, const CenterCondition& center) {
  const ContactPlace& place = touch.place;
  const SurfaceGrid& grid = pair_->nodes.grid;
  const double compliance = touch.yielding.sum;
  const HalfField& known = touch.known.front();
  const ArrayXd weights = half_weights(pair_->half_nodes()).replicate(place.count, 1);
  const SurfaceWindow before(grid, place.nodes.window(),
                             place.nodes.shift() - (end.angle - now_.angle) / grid.phi_spacing);
  const Axes axes_before = axes_at(*pair_, before);
  const HalfField borne = memories_.front().displacement(place.first, place.count);
  const auto part = [](const Axes& axes, std::size_t axis, const HalfField& field) -> ArrayXd {
    return along(axes[axis], field).reshaped();
  };
  const StickSlipProblem problem{
      .tables = *touch.yielding.of_bodies.front().tables,
      .axes = place.axes,
      .gap = weights * place.gap + part(place.axes, kDown, known),
      .forward_way = weights * (place.nodes.x() - before.x()) - part(place.axes, kForward, known) +
                     part(axes_before, kForward, borne),
      .sideways_way = weights * (place.nodes.z() - before.z()) - part(place.axes, kSideways, known) +
                      part(axes_before, kSideways, borne),
      .weights = weights,
      .load = compliance * end.load,
      .friction = pair_->friction,
      .center = {.force = center.force, .way = compliance * center.way, .value = compliance * center.value}};
  return solve_stick_slip(problem, carried_forces(*pair_, place, last_forces(), problem.load), stiffness_);
}

/// What is below does to the nodes.
HalfField Lattice::by_components(const VectorField& force, const ContactPlace& place) const {
  return coating().components() == 1 ? as_field(-force.col(kDown), pair_->half_nodes()) : on_plane(place.axes, force);
}

void Lattice::forget_contact() {
  inverse_ = {};
  stiffness_ = {};
}

RowMemory::Load Lattice::load_of(const Touch& touch, std::size_t body) const {
  const ContactPlace& place = touch.place;
  const CreepingTables& tables = pair_->bodies[body].tables;
  const Index reach = tables.reach();
  RowMemory::Load load{.first = place.first - reach,
                       .force = HalfField::Zero(tables.height(), place.count + 2 * reach),
                       .displacements = {}};
  for (const HalfField& moved : touch.moved[body]) load.displacements.emplace_back(moved / touch.yielding.sum);
  load.force.middleCols(reach, place.count) = by_components(touch.contact.force, place) / touch.yielding.sum;
  return load;
}

/// All of a body's own displacement in the window.
HalfField Lattice::deformed(const Touch& touch, std::size_t body) const {
  HalfField deformed = touch.known[body];
  const std::vector<double>& parts = touch.yielding.of_bodies[body].parts;
  const Index reach = pair_->bodies[body].tables.reach();
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const double share = parts[t] / touch.yielding.sum;
    deformed += share * touch.moved[body][t].middleCols(reach, touch.place.count);
  }
  return deformed;
}

void Lattice::take(const Touch& touch, const StepEnd& end) {
  now_.angle = end.angle;
  now_.load = end.load;
  take_contact(touch);
  take_moments(touch);
  if (has_friction()) take_friction(touch);
  force_ = touch.contact.force / touch.yielding.sum;
  first_ = touch.place.first;
  count_ = touch.place.count;
  lowest_ = touch.place.nodes.shift();
}

void Lattice::take_contact(const Touch& touch) {
  const SurfaceWindow& nodes = touch.place.nodes;
  const ArrayXd weights = half_weights(pair_->half_nodes()).replicate(touch.place.count, 1);
  const ArrayXd forces = -touch.contact.force.col(kDown) / touch.yielding.sum;
  now_.penetration = touch.contact.penetration;
  const double coating_thickness = thickness(pair_->pair);
  if (now_.penetration >= coating_thickness) {
    reject("load", "small enough for the coating",
           text(now_.load) + " " + std::string(pair_->pair.body.form.load_unit) + " (it is pressed " +
               rounded(now_.penetration) + " m into a coating of " + text(coating_thickness) + " m)");
  }

  const ArrayXd patches = nodes.patch_area();
  ArrayXd touching = ArrayXd::Zero(forces.size());
  for (const Index node : touch.contact.nodes) touching[node] = weights[node] * weights[node] * patches[node];
  const ContactExtent extent = contact_extent(nodes, touching, 0.0);
  now_.contact_area = extent.area;
  now_.semi_axis_x = extent.semi_axis_x;
  now_.semi_axis_z = extent.semi_axis_z.value_or(std::numeric_limits<double>::quiet_NaN());
  now_.max_pressure = (forces / weights).maxCoeff() / flat_patch(nodes.grid());
}

/// D_2, the force of the pressure along the counterpart's own deformed surface: theory.md section 15.
double Lattice::pushback(const Touch& touch, const ArrayXd& pressing) const {
  const auto& bodies = pair_->bodies;
  if (bodies.size() == 1) return bodies.front().rolls ? 0.0 : now_.resisting_torque / relative_radius(pair_->pair);
  const SurfaceGrid& grid = pair_->nodes.grid;
  const ArrayXd weights = half_weights(pair_->half_nodes()).replicate(touch.place.count, 1);
  const ArrayXd depth = deformed(touch, 1).reshaped().array() / weights;
  return (pressing * patch_slope(depth, pair_->half_nodes(), grid.radius * grid.phi_spacing)).sum();
}

/// About the center. Pressure works along the plane where it moves what it stands on along it.
void Lattice::take_moments(const Touch& touch) {
  const ArrayXd weights = half_weights(pair_->half_nodes()).replicate(touch.place.count, 1);
  const VectorField force = touch.contact.force.colwise() * weights / touch.yielding.sum;
  const double radius = pair_->nodes.grid.radius;
  const double turning = pair_->pair.on.curvatures.along;  // of what it rolls on [1/m]
  now_.resisting_torque = -(touch.place.lever * force.col(kDown)).sum();
  const double pushed_back = pushback(touch, -force.col(kDown));
  now_.driving_force = pushed_back - turning * now_.resisting_torque;
  now_.driving_torque = radius / relative_radius(pair_->pair) * now_.resisting_torque - radius * pushed_back;
  if (coating().components() == 1) return;
  LeverArms arms{.x = touch.place.lever,
                 .y = ArrayXd::Constant(weights.size(), radius - touch.contact.penetration),
                 .radius = radius};
  if (pair_->compliance == Compliance::vertical) {
    arms.x -= along(touch.place.axes[kForward], deformed(touch, 0)).reshaped().array() / weights;
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
  const Index half_nodes = pair_->half_nodes();
  VectorField force = touch.contact.force / touch.yielding.sum;
  for (Index row = 0; row < touch.place.count; ++row) {
    const Index last = touch.place.first + row - first_;
    if (last < 0 || last >= count_) continue;
    force.middleRows(half_nodes * row, half_nodes) += force_.middleRows(half_nodes * last, half_nodes);
  }
  const auto& slip = touch.contact.slip;
  return -0.5 * (force.col(kForward) * slip.col(0) + force.col(kSideways) * slip.col(1)).sum();
}

void Lattice::start(Start start, const StepEnd& at, double center_speed) {
  const bool relaxed = start == Start::relaxed;
  const Yielding yielding = this->yielding([&](std::size_t b) {
    const CreepingBody& body = pair_->bodies[b];
    return relaxed ? body.parts_at_rest() : body.parts_at_once();
  });
  now_.angle = at.angle;
  // With friction, pressing depends on its path: the load rises in steps, without a force on the center.
  const int count = has_friction() ? kPressingSteps : 1;
  for (int i = 1; i <= count; ++i) {
    StepEnd end = at;
    end.load *= static_cast<double>(i) / count;
    const Touch contact = touch(nullptr, yielding, end, {});
    take(contact, end);
    for (std::size_t b = 0; b < memories_.size(); ++b) {
      if (relaxed) {
        memories_[b].relax(load_of(contact, b));
      } else {
        memories_[b].press(load_of(contact, b));
      }
    }
  }
  take_stored_energy();
  now_.dissipated_energy = now_.counterpart_dissipated_energy = now_.slip_energy = 0.0;
  now_.center_speed = center_speed;
}

void Lattice::advance(const PairStep& step, const StepEnd& end) {
  const RollingInstant before = now_;
  const double duration = step.duration;
  const Yielding yielding = this->yielding([&](std::size_t b) { return pair_->bodies[b].parts_after(step.parts[b]); });
  const Touch contact = touch(&step, yielding, end, center_condition(*pair_, now_, duration, end));
  take(contact, end);
  if (has_friction()) move_center(pair_->mass, duration, contact.contact.way, center_acceleration_, now_);
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    const double lost = memories_[b].advance(step.parts[b], duration, load_of(contact, b));
    now_.dissipated_energy += lost;
    if (!pair_->bodies[b].rolls) now_.counterpart_dissipated_energy += lost;
  }
  take_stored_energy();
  const double used = now_.stored_energy - before.stored_energy + now_.dissipated_energy - before.dissipated_energy;
  // A jump is elastic, whatever its way: it takes the energy that it stores.
  const double work = duration == 0.0
                          ? used
                          : 0.5 * ((working_torque(before) + working_torque(now_)) * (end.angle - before.angle) +
                                   (before.load + end.load) * (now_.penetration - before.penetration) +
                                   (before.driving_force + now_.driving_force) * (now_.center_way - before.center_way));
  now_.work += work;
  now_.energy_imbalance += work - used;
}

/// What works by the turning: without friction the force along what deforms below does, too, for it never slips.
double Lattice::working_torque(const RollingInstant& at) const {
  if (has_friction()) return at.driving_torque;
  const double along = at.driving_force + pair_->pair.on.curvatures.along * at.resisting_torque;
  return at.driving_torque + pair_->nodes.grid.radius * along;
}

void Lattice::take_stored_energy() {
  now_.stored_energy = now_.counterpart_stored_energy = 0.0;
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    now_.stored_energy += memories_[b].stored_energy();
    if (!pair_->bodies[b].rolls) now_.counterpart_stored_energy += memories_[b].stored_energy();
  }
}

void Lattice::widen(std::shared_ptr<const CreepingPair> pair) {
  const Index before = pair_->half_nodes();
  pair_ = std::move(pair);
  for (std::size_t b = 0; b < memories_.size(); ++b) memories_[b] = memories_[b].widened(pair_->bodies[b].tables);
  last_.clear();
  forget_contact();
  const Index half_nodes = pair_->half_nodes();
  VectorField wide = VectorField::Zero(half_nodes * count_, 3);
  for (Index row = 0; row < count_; ++row) {
    wide.middleRows(half_nodes * row, before) = force_.middleRows(before * row, before);
  }
  force_ = std::move(wide);
}

void Lattice::write(NumberWriter& numbers) const {
  for (const auto member : kLatticeScalars) numbers.put(now_.*member);
  numbers.put(center_acceleration_);
  numbers.put(static_cast<double>(half_rows_));
  numbers.put(lowest_);
  numbers.put(static_cast<double>(first_));
  numbers.put(static_cast<double>(count_));
  for (const auto& [axis, sign] : kSaved) numbers.put(as_field(sign * force_.col(axis), pair_->half_nodes()));
  for (const RowMemory& memory : memories_) memory.write(numbers);
  // What is known of the last contact and the last step: the next one is then the same to the last bit.
  for (std::size_t b = 0; b < memories_.size(); ++b)
    numbers.put(last_.empty() ? std::vector<double>{} : last_[b].parts);
  inverse_.write(numbers);
  stiffness_.write(numbers);
}

void Lattice::read(NumberReader& numbers) {
  for (const auto member : kLatticeScalars) now_.*member = numbers.get();
  center_acceleration_ = numbers.get();
  half_rows_ = numbers.count(static_cast<double>(pair_->nodes.widest.phi.last));
  lowest_ = numbers.get();
  first_ = numbers.row();
  count_ = numbers.count();
  force_ = VectorField::Zero(pair_->half_nodes() * count_, 3);
  for (const auto& [axis, sign] : kSaved) {
    const HalfField field = numbers.matrix();
    if (field.size() == force_.rows()) force_.col(axis) = sign * field.reshaped();
  }
  memories_.clear();
  for (const CreepingBody& body : pair_->bodies) {
    memories_.emplace_back(body);
    memories_.back().read(numbers, body.tables);
  }
  last_.clear();
  for (const CreepingBody& body : pair_->bodies) {
    std::vector<double> parts = numbers.values();
    if (parts.empty()) continue;
    NumberReader::require(parts.size() == body.tables.count());
    last_.push_back(body.tables.yielding(std::move(parts)));
  }
  const Index last = pair_->half_nodes() * (2 * half_rows_ + 1) - 1;
  inverse_.read(numbers, last);
  stiffness_.read(numbers, last);
}

ContactField Lattice::field() const {
  const ContactPlace place = place_at(*pair_, shift_, half_rows_, now_.angle);
  const Index half_nodes = pair_->half_nodes();
  const Index sides = 2 * half_nodes - 1;
  const double patch = flat_patch(pair_->nodes.grid);
  const ArrayXd weights = half_weights(half_nodes);
  ContactField field{.phi_nodes = static_cast<int>(place.count), .theta_nodes = static_cast<int>(sides)};
  for (Index i = 0; i < place.count; ++i) {
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
