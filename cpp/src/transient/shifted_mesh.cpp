#include "transient/shifted_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "base/validate.hpp"
#include "rolling/input_checks.hpp"
#include "transient/center_motion.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Number of steps in which the load is applied with friction.
constexpr int kPressingSteps = 8;

/// Whether compliance factors are equal, up to the round-off of the durations of steps.
bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kRoundOff = 1e-10;
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= kRoundOff * std::abs(x); });
}

/// Order and signs of forces in saved states: pressing, forward, sideways.
constexpr std::array<std::pair<Axis, double>, 3> kSaved{{{kDown, -1.0}, {kForward, 1.0}, {kSideways, 1.0}}};

}  // namespace

ShiftedMesh::ShiftedMesh(std::shared_ptr<const ViscoelasticPair> pair, double shift, Index half_rows)
    : pair_(std::move(pair)), shift_(shift), half_rows_(half_rows) {
  for (const ViscoelasticBody& body : pair_->bodies) memories_.emplace_back(body);
}

/// Tables that are sums are reused while steps have the same duration.
template <class Parts>
InstantaneousCompliance ShiftedMesh::instantaneous(const Parts& parts_in, const Checkpoint& checkpoint) {
  last_.resize(pair_->bodies.size());
  InstantaneousCompliance instantaneous{.of_bodies = {}, .sum = 0.0};
  for (std::size_t b = 0; b < last_.size(); ++b) {
    const CreepTables& tables = pair_->bodies[b].tables;
    std::vector<double> parts = parts_in(b);
    if (tables.count() == 1 || !are_same(parts, last_[b].parts)) {
      last_[b] = tables.instantaneous(std::move(parts), checkpoint);
      if (tables.count() > 1) forget_contact();
    }
    instantaneous.sum += last_[b].share;
  }
  instantaneous.of_bodies = last_;
  return instantaneous;
}

InstantContact ShiftedMesh::instant(const Attempt& attempt) {
  const StepEnd& end = attempt.end;
  for (;;) {
    InstantContact instant = before_contact(attempt.step, attempt.instantaneous, end, attempt.checkpoint);
    if (approach(attempt).force != 0.0 && approach(attempt).penetration == 0.0 && end.load == 0.0) {
      instant.contact = solve_lifted(*pair_, instant, attempt.center);
    } else {
      require_open_track(instant.place);
      instant.contact = search(attempt, instant);
      if (!fits(instant, end.load)) continue;
    }
    if (!reaches_all(instant, end)) continue;
    find_displacements(*pair_, instant);
    return instant;
  }
}

InstantContact ShiftedMesh::before_contact(const PairStep* step, const InstantaneousCompliance& instantaneous,
                                           const StepEnd& end, const Checkpoint& checkpoint) const {
  InstantContact instant{.place = place_at(*pair_, shift_, half_rows_, end.angle, ahead_),
                         .instantaneous = instantaneous,
                         .known = {},
                         .contact = {},
                         .moved = {},
                         .checkpoint = checkpoint};
  require_reach(instant.place);
  const auto& [first, count] = std::pair(instant.place.first, instant.place.count);
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    const Index height = pair_->bodies[b].tables.height();
    instant.known.push_back(step != nullptr ? memories_[b].known_displacement(step->parts[b], first, count)
                                            : HalfField::Zero(height, count));
  }
  return instant;
}

/// Search for a contact. If there is none, check whether the load or the drive is the cause, and reject it.
template <class Search>
auto ShiftedMesh::explaining_failure(const Attempt& attempt, const Search& search) {
  try {
    return search();
  } catch (const ConvergenceError&) {
    require_supported_load(attempt);
    require_reachable_drive(attempt);
    throw;
  }
}

/// Reject a load that is too large for the coating even without friction.
void ShiftedMesh::require_supported_load(const Attempt& attempt) {
  const double load = attempt.end.load;
  for (bool is_within = false; !is_within;) {
    InstantContact instant = before_contact(attempt.step, attempt.instantaneous, attempt.end, attempt.checkpoint);
    instant.contact = solve_frictionless(*pair_, instant, last_forces(), approach(attempt), inverse_);
    is_within = fits(instant, load);
    if (is_within) require_depth(pair_->pair, load, instant.contact.penetration);
  }
}

double ShiftedMesh::load_without_friction(const Attempt& attempt) {
  for (;;) {
    InstantContact instant = before_contact(attempt.step, attempt.instantaneous, attempt.end, attempt.checkpoint);
    instant.contact = solve_frictionless(*pair_, instant, last_forces(), approach(attempt), inverse_);
    if (!fits(instant, attempt.end.load) || !reaches_all(instant, attempt.end)) continue;
    return -(instant.place.weights * instant.contact.force.col(kDown)).sum() / instant.instantaneous.sum;
  }
}

/// Reject a force on the center, or a moment about it, that friction does not balance even if the body slides as a
/// whole, forward or backward. The check for steady rolling is that of docs/theory/friction.md.
void ShiftedMesh::require_reachable_drive(const Attempt& attempt) {
  const CenterCondition& center = attempt.center;
  if (!pair_->has_friction() || center.displacement != 0.0) return;
  std::array<RollingInstant, 2> sliding;
  try {
    sliding = {slid(attempt, Sense::back), slid(attempt, Sense::forward)};
  } catch (const ConvergenceError&) {
    return;  // there is no range to compare with
  }
  const RoundBody& body = *pair_->pair.body;
  const auto require = [&](double RollingInstant::* member, const std::string& name, double given,
                           std::string_view unit) {
    const auto [least, most] = std::minmax(sliding[0].*member, sliding[1].*member);
    if (given > least && given < most) return;
    const auto in_units = [unit](const std::string& number) { return number + " " + std::string(unit); };
    reject(name,
           "between " + in_units(rounded(least)) + " and " + in_units(rounded(most)) + " at angle " +
               rounded(attempt.end.angle) + " rad, otherwise the " + std::string(body.name()) + " slides permanently",
           in_units(text(given)),
           Range{.unit = std::string(unit),
                 .minimum = least,
                 .maximum = most,
                 .excludes_minimum = true,
                 .excludes_maximum = true});
  };
  if (center.torque != 0.0) {
    const double given = *pair_->driving_torque;
    require(&RollingInstant::driving_torque, "driving_torque", given, body.form().torque_unit);
  } else {
    require(&RollingInstant::driving_force, "driving_force", 0.0 - center.value, body.form().load_unit);
  }
}

/// Contact of a body that slides as a whole: its center moves by a radius, much farther than the forces displace any
/// node.
RollingInstant ShiftedMesh::slid(const Attempt& attempt, Sense sense) {
  const double radius = pair_->nodes.grid.radius;
  const CenterCondition led{
      .force = 0.0, .torque = 0.0, .displacement = 1.0, .value = sense == Sense::forward ? radius : -radius};
  for (;;) {
    InstantContact instant = before_contact(attempt.step, attempt.instantaneous, attempt.end, attempt.checkpoint);
    instant.contact = search({attempt.step, attempt.instantaneous, attempt.end, led, attempt.checkpoint}, instant);
    if (!fits(instant, attempt.end.load)) continue;
    find_displacements(*pair_, instant);
    RollingInstant now;
    static_cast<void>(set_moments(*pair_, instant, now));
    return now;
  }
}

StickSlip ShiftedMesh::search(const Attempt& attempt, const InstantContact& instant) {
  if (!pair_->has_friction()) return solve_frictionless(*pair_, instant, last_forces(), approach(attempt), inverse_);
  const StepEnd& end = attempt.end;
  const Departure departure{.turned = end.angle - now_.angle, .loaded_displacements = displacements(instant.place)};
  StickSlip contact = solve_frictional(*pair_, instant, last_forces(), departure, approach(attempt), attempt.center,
                                       inverse_, stiffness_);
  if (!contact.nodes.empty()) return contact;
  // In flight, a center without a given displacement moves on by its own equation or, without mass, at its speed.
  const CenterCondition& center = attempt.center;
  const double duration = attempt.step != nullptr ? attempt.step->duration : 0.0;
  contact.center_displacement =
      center.displacement != 0.0 ? center.coasted + center.value / center.displacement : duration * now_.center_speed;
  return contact;
}

ApproachCondition ShiftedMesh::approach(const Attempt& attempt) const {
  const double compliance = attempt.instantaneous.sum;
  const StepEnd& end = attempt.end;
  if (end.axle_height) return {.force = 0.0, .penetration = 1.0, .value = pair_->nodes.grid.radius - *end.axle_height};
  if (!pair_->axle || attempt.step == nullptr) return {.value = compliance * end.load};
  return scaled(axle_condition(*pair_->axle, now_, axle_, *attempt.step, end.load), compliance);
}

std::vector<HalfField> ShiftedMesh::displacements(const ContactPlace& place) const {
  std::vector<HalfField> fields;
  fields.reserve(memories_.size());
  for (const RowMemory& memory : memories_) fields.push_back(memory.displacement(place.first, place.count));
  return fields;
}

/// If displacements do not decay, as on a half-space, the whole memory of a track displaces the contact.
void ShiftedMesh::require_reach(const ContactPlace& place) const {
  if (pair_->track_reach >= pair_->max_track_reach()) return;
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    const CreepTables& tables = pair_->bodies[b].tables;
    const auto alive = memories_[b].living();
    if (!alive || tables.dies_out()) continue;
    const Index farthest = std::max(place.first + place.count - 1 - alive->first, alive->last - place.first);
    if (farthest > tables.reach()) throw TrackTooLong();
  }
}

/// A dish or a ring closes on itself, but the rows of a track do not: the contact would not meet the memory ahead of
/// it.
void ShiftedMesh::require_open_track(const ContactPlace& place) const {
  const double turning = std::abs(pair_->pair.on->curvatures().along);
  if (turning == 0.0) return;
  const double spacing = pair_->nodes.grid.radius * pair_->nodes.grid.phi_spacing;
  const double around = 2.0 * std::numbers::pi / turning;
  for (const RowMemory& memory : memories_) {
    const auto alive = memory.living();
    if (!alive) continue;
    const Index rows = std::max(place.first + place.count - 1, alive->last) - std::min(place.first, alive->first) + 1;
    const double distance = spacing * static_cast<double>(rows);
    if (distance <= around) continue;
    reject("distance",
           "less than the circumference of the counterbody, " + rounded(around) + " m, until its surface has recovered",
           rounded(distance) + " m");
  }
}

/// Whether the contact ends within the window; if not, widen the window.
bool ShiftedMesh::fits(const InstantContact& instant, double load) {
  if (instant.contact.nodes.empty()) return true;
  const Index half_nodes = pair_->half_nodes();
  const Index most = pair_->nodes.widest.phi.last;
  bool at_side = false;
  bool at_end = false;
  for (const Index node : instant.contact.nodes) {
    at_side = at_side || node % half_nodes == half_nodes - 1;
    at_end = at_end || node / half_nodes == 0 || node / half_nodes == instant.place.count - 1;
  }
  if (at_side && !pair_->ends_at_sides()) throw ContactTooWide();
  if (!at_end) return true;
  if (half_rows_ >= most) reject_contact_over_60_degrees(pair_->pair, load);
  widen_window(std::min(half_rows_ + half_rows_ / 2 + 1, most));
  return false;
}

bool ShiftedMesh::reaches_all(const InstantContact& instant, const StepEnd& end) {
  const Index needed = half_rows_in_reach(*pair_, shift_, end.angle, ahead_, limit_of_touch(*pair_, instant));
  if (needed <= half_rows_) return true;
  widen_window(needed);
  return false;
}

void ShiftedMesh::widen_window(Index half_rows) {
  half_rows_ = half_rows;
  forget_contact();
}

void ShiftedMesh::forget_contact() {
  inverse_.forget();
  stiffness_.forget();
}

void ShiftedMesh::take(const InstantContact& instant, const StepEnd& end) {
  now_.angle = end.angle;
  const bool is_load_given = !end.axle_height && !pair_->axle;
  const ArrayXd pressing = -instant.contact.force.col(kDown) * instant.place.weights;
  now_.load = is_load_given ? end.load : pressing.sum() / instant.instantaneous.sum;
  now_.axle_force = end.axle_height ? now_.load : end.load;
  set_extent(*pair_, instant, now_);
  power_ = set_moments(*pair_, instant, now_);
  if (pair_->has_friction()) take_friction(instant);
  force_ = instant.contact.force / instant.instantaneous.sum;
  first_ = instant.place.first;
  count_ = instant.place.count;
  lowest_ = instant.place.nodes.shift();
}

void ShiftedMesh::take_friction(const InstantContact& instant) {
  const StickSlip& contact = instant.contact;
  const double lost = slip_work(instant);
  now_.dissipated_energy += lost;
  now_.slip_energy += lost;
  now_.stick_share = static_cast<double>(contact.sticking) / std::max(1.0, static_cast<double>(contact.nodes.size()));
}

/// Energy dissipated by slip in a step, from the mean of the old and new tractions of each node.
double ShiftedMesh::slip_work(const InstantContact& instant) const {
  const Index half_nodes = pair_->half_nodes();
  VectorField force = instant.contact.force / instant.instantaneous.sum;
  for (Index row = 0; row < instant.place.count; ++row) {
    const Index last = instant.place.first + row - first_;
    if (last < 0 || last >= count_) continue;
    force.middleRows(half_nodes * row, half_nodes) += force_.middleRows(half_nodes * last, half_nodes);
  }
  const auto& slip = instant.contact.slip;
  return -0.5 * (force.col(kForward) * slip.col(0) + force.col(kSideways) * slip.col(1)).sum();
}

void ShiftedMesh::start(Start start, const StepEnd& at, double center_speed, const Checkpoint& checkpoint) {
  const bool relaxed = start == Start::relaxed;
  const auto parts_in = [&](std::size_t b) {
    const ViscoelasticBody& body = pair_->bodies[b];
    return relaxed ? body.relaxed_factors() : body.instantaneous_factors();
  };
  const InstantaneousCompliance instantaneous = this->instantaneous(parts_in, checkpoint);
  now_.angle = at.angle;
  const CenterCondition unpushed;
  const auto attempt_at = [&](const StepEnd& end) {
    return Attempt{
        .step = nullptr, .instantaneous = instantaneous, .end = end, .center = unpushed, .checkpoint = checkpoint};
  };
  explaining_failure(attempt_at(at), [&] {
    // With friction, pressing depends on its path: the load rises in steps, without a force on the center. It reaches a
    // given height of the axle in the last step.
    const int count = pair_->has_friction() ? kPressingSteps : 1;
    StepEnd pressed = at;
    if (at.axle_height && pair_->has_friction()) pressed.load = load_without_friction(attempt_at(at));
    for (int i = 1; i <= count; ++i) {
      StepEnd end = pressed;
      end.load *= static_cast<double>(i) / count;
      if (i < count) end.axle_height.reset();
      const InstantContact contact = instant(attempt_at(end));
      take(contact, end);
      for (std::size_t b = 0; b < memories_.size(); ++b) {
        if (relaxed) {
          memories_[b].relax(load_of(*pair_, contact, b));
        } else {
          memories_[b].press(load_of(*pair_, contact, b));
        }
      }
    }
  });
  take_stored_energy();
  now_.dissipated_energy = now_.counterbody_dissipated_energy = now_.slip_energy = 0.0;
  now_.center_speed = center_speed;
  axle_.rest = now_.penetration;
}

void ShiftedMesh::advance(const PairStep& step, const StepEnd& end, const Checkpoint& checkpoint) {
  const RollingInstant before = now_;
  const CenterPower power = power_;
  const double duration = step.duration;
  const auto parts_in = [&](std::size_t b) { return pair_->bodies[b].step_factors(step.parts[b]); };
  const InstantaneousCompliance instantaneous = this->instantaneous(parts_in, checkpoint);
  const CenterCondition center = center_condition(*pair_, now_, duration, end);
  const Attempt attempt{
      .step = &step, .instantaneous = instantaneous, .end = end, .center = center, .checkpoint = checkpoint};
  const InstantContact contact = explaining_failure(attempt, [&] { return instant(attempt); });
  take(contact, end);
  move_axle(pair_->axle, step, before, axle_, now_);
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    lose(memories_[b].advance(step.parts[b], duration, load_of(*pair_, contact, b)), pair_->bodies[b].rolls);
  }
  const double turn = end.angle - before.angle;
  double displacement = pair_->nodes.grid.radius * turn;
  if (pair_->has_friction()) {
    move_center(pair_->mass, duration, contact.contact.center_displacement, center_acceleration_, now_);
    lose(0.5 * (power.creeping + power_.creeping) * (contact.contact.center_displacement - displacement), false);
    ahead_ += contact.contact.center_displacement - displacement;
    displacement = contact.contact.center_displacement;
  }
  take_stored_energy();
  const double used = now_.stored_energy - before.stored_energy + now_.dissipated_energy - before.dissipated_energy +
                      now_.axle_energy - before.axle_energy;
  // A jump is elastic over any distance: its work is the energy that it stores.
  const double work = duration == 0.0
                          ? used
                          : 0.5 * ((before.driving_torque + now_.driving_torque) * turn +
                                   (before.axle_force + now_.axle_force) * (now_.penetration - before.penetration) +
                                   (power.along_track + power_.along_track) * displacement);
  now_.work += work;
  now_.energy_balance_residual += work - used;
}

void ShiftedMesh::lose(double energy, bool in_rolling_body) {
  now_.dissipated_energy += energy;
  if (!in_rolling_body) now_.counterbody_dissipated_energy += energy;
}

void ShiftedMesh::take_stored_energy() {
  now_.stored_energy = now_.counterbody_stored_energy = 0.0;
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    now_.stored_energy += memories_[b].stored_energy();
    if (!pair_->bodies[b].rolls) now_.counterbody_stored_energy += memories_[b].stored_energy();
  }
}

void ShiftedMesh::widen(std::shared_ptr<const ViscoelasticPair> pair, const Checkpoint& checkpoint) {
  const Index before = pair_->half_nodes();
  pair_ = std::move(pair);
  for (std::size_t b = 0; b < memories_.size(); ++b) {
    memories_[b] = memories_[b].widened(pair_->bodies[b].tables, checkpoint);
  }
  last_.clear();
  forget_contact();
  const Index half_nodes = pair_->half_nodes();
  VectorField wide = VectorField::Zero(half_nodes * count_, 3);
  for (Index row = 0; row < count_; ++row) {
    wide.middleRows(half_nodes * row, before) = force_.middleRows(before * row, before);
  }
  force_ = std::move(wide);
}

void ShiftedMesh::write(NumberWriter& numbers) const {
  for (const auto member : kShiftedMeshScalars) numbers.put(now_.*member);
  for (const double number : {center_acceleration_, ahead_, axle_.acceleration, axle_.rest}) numbers.put(number);
  numbers.put(power_.along_track);
  numbers.put(power_.creeping);
  numbers.put(static_cast<double>(half_rows_));
  numbers.put(lowest_);
  numbers.put(static_cast<double>(first_));
  numbers.put(static_cast<double>(count_));
  for (const auto& [axis, sign] : kSaved) numbers.put(as_field(sign * force_.col(axis), pair_->half_nodes()));
  for (const RowMemory& memory : memories_) memory.write(numbers);
  // Data of the last contact and the last step, so that the next step is identical to the last bit.
  for (std::size_t b = 0; b < memories_.size(); ++b)
    numbers.put(last_.empty() ? std::vector<double>{} : last_[b].parts);
  inverse_.write(numbers);
  stiffness_.write(numbers);
}

void ShiftedMesh::read(NumberReader& numbers, const Checkpoint& checkpoint) {
  for (const auto member : kShiftedMeshScalars) {
    // A line contact has no width.
    now_.*member = member == &RollingInstant::semi_axis_z ? numbers.get_if_any() : numbers.get();
  }
  const double spacing = pair_->nodes.grid.phi_spacing;
  NumberReader::require(std::abs(now_.angle) <= kMaxRows * spacing && now_.load >= 0.0);
  for (double* number : {&center_acceleration_, &ahead_, &axle_.acceleration, &axle_.rest}) *number = numbers.get();
  power_ = {.along_track = numbers.get(), .creeping = numbers.get()};
  half_rows_ = numbers.count(static_cast<double>(pair_->nodes.widest.phi.last));
  lowest_ = numbers.get();
  first_ = numbers.row();
  count_ = numbers.count();
  const ContactPlace place = place_at(*pair_, shift_, half_rows_, now_.angle, ahead_);
  NumberReader::require(first_ == place.first && count_ == place.count);
  force_ = VectorField::Zero(pair_->half_nodes() * count_, 3);
  for (const auto& [axis, sign] : kSaved) {
    const HalfField field = numbers.matrix();
    NumberReader::require(field.size() == force_.rows());
    force_.col(axis) = sign * field.reshaped();
  }
  memories_.clear();
  for (const ViscoelasticBody& body : pair_->bodies) {
    memories_.emplace_back(body);
    memories_.back().read(numbers, body.tables);
    NumberReader::require(memories_.back().keeps(first_) && memories_.back().keeps(first_ + count_ - 1));
  }
  last_.clear();
  for (const ViscoelasticBody& body : pair_->bodies) {
    std::vector<double> parts = numbers.values();
    if (parts.empty()) continue;
    NumberReader::require(parts.size() == body.tables.count());
    last_.push_back(body.tables.instantaneous(std::move(parts), checkpoint));
  }
  const Index last = pair_->half_nodes() * (2 * half_rows_ + 1) - 1;
  inverse_.read(numbers, last);
  stiffness_.read(numbers, last);
}

ContactField ShiftedMesh::field() const {
  const ContactPlace place = place_at(*pair_, shift_, half_rows_, now_.angle, ahead_);
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
