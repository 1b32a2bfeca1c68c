#include "transient/ring_memory.hpp"

#include <algorithm>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

Index on_ring(Index row, Index ring) { return ((row % ring) + ring) % ring; }

double inner(const HalfField& a, const HalfField& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

RingMemory::RingMemory(const MirroredTables& tables, const CreepSpectrum& spectrum)
    : instantaneous_(spectrum.instantaneous), weights_(spectrum.weights) {
  const HalfField zero = HalfField::Zero(tables.height(), tables.ring());
  now_ = {zero, zero};
  retarded_.assign(spectrum.size(), now_);
}

void RingMemory::set(const Load& load, Retarded& field) const {
  field.force = HalfField::Zero(load.force.rows(), ring());
  field.displacement = field.force;
  // Rows within reach may go around the ring more than once.
  for (Index i = 0; i < load.rows.count; ++i) {
    const Index row = (load.rows.first + i) % ring();
    field.force.col(row) += load.force.col(i);
    field.displacement.col(row) += load.displacement.col(i);
  }
}

void RingMemory::relax(const Load& load) {
  set(load, now_);
  std::ranges::fill(retarded_, now_);
  find_stored_energy();
}

void RingMemory::press(const Load& load) {
  set(load, now_);
  find_stored_energy();
}

double RingMemory::advance(const TimeStep& step, const Load& load) {
  Retarded next;
  set(load, next);
  const HalfField change = next.force - now_.force;
  const HalfField change_displacement = next.displacement - now_.displacement;
  const double changed = inner(change, change_displacement);
  double lost = 0.0;
  stored_ = 0.5 * instantaneous_ * inner(next.force, next.displacement);
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    const TimeStep::Term& term = step.terms[j];
    auto& [force, displacement] = retarded_[j];
    double mixed = 0.0;
    double state = 0.0;
    double stored = 0.0;
    for (Index row = 0; row < ring(); ++row) {
      const auto behind = (now_.displacement.col(row) - displacement.col(row)).eval();
      mixed += change.col(row).dot(behind);
      state += (now_.force.col(row) - force.col(row)).dot(behind);
      force.col(row) =
          term.decay * force.col(row) + term.on_old * now_.force.col(row) + term.on_new * next.force.col(row);
      displacement.col(row) = term.decay * displacement.col(row) + term.on_old * now_.displacement.col(row) +
                              term.on_new * next.displacement.col(row);
      stored += force.col(row).dot(displacement.col(row));
    }
    lost += term.lost_change * changed + term.lost_mixed * mixed + term.lost_state * state;
    stored_ += 0.5 * term.weight * stored;
  }
  now_ = std::move(next);
  return lost;
}

HalfField RingMemory::known_displacement(const TimeStep& step, const RingRows& rows) const {
  HalfField known(now_.force.rows(), rows.count);
  double on_old = 0.0;
  for (const TimeStep::Term& term : step.terms) on_old += term.weight * term.on_old;
  for (Index i = 0; i < rows.count; ++i) {
    const Index row = (rows.first + i) % ring();
    known.col(i) = on_old * now_.displacement.col(row);
    for (std::size_t j = 0; j < retarded_.size(); ++j) {
      known.col(i) += step.terms[j].weight * step.terms[j].decay * retarded_[j].displacement.col(row);
    }
  }
  return known;
}

HalfField RingMemory::displacement(const RingRows& rows) const {
  HalfField field(now_.force.rows(), rows.count);
  for (Index i = 0; i < rows.count; ++i) {
    const Index row = (rows.first + i) % ring();
    field.col(i) = instantaneous_ * now_.displacement.col(row);
    for (std::size_t j = 0; j < retarded_.size(); ++j) field.col(i) += weights_[j] * retarded_[j].displacement.col(row);
  }
  return field;
}

RingMemory::Retarded RingMemory::displaced(const HalfField& force, const MirroredTables& tables) const {
  const Index reach = tables.reach();
  Load load{.rows = {.first = on_ring(-reach, ring()), .count = ring() + 2 * reach},
            .force = HalfField::Zero(tables.height(), ring() + 2 * reach),
            .displacement = tables.displacement_in_reach(force, 0, ring() - 1)};
  load.force.middleCols(reach, ring()) = force;
  Retarded result;
  set(load, result);
  return result;
}

void RingMemory::write(NumberWriter& numbers) const {
  numbers.put(now_.force);
  for (const Retarded& retarded : retarded_) numbers.put(retarded.force);
}

void RingMemory::read(NumberReader& numbers, const MirroredTables& tables) {
  const auto field = [&] {
    const HalfField force = numbers.matrix();
    if (force.rows() != tables.height() || force.cols() != ring()) {
      reject("start", "a state of the same mesh", "one of another mesh");
    }
    return displaced(force, tables);
  };
  now_ = field();
  for (Retarded& retarded : retarded_) retarded = field();
  find_stored_energy();
}

RingMemory RingMemory::widened(const MirroredTables& tables) const {
  const Index components = tables.components();
  const Index before = now_.force.rows() / components;
  const auto widen = [&](const Retarded& narrow) {
    HalfField force = HalfField::Zero(tables.height(), ring());
    for (Index component = 0; component < components; ++component) {
      force.middleRows(component * tables.half_nodes(), before) = narrow.force.middleRows(component * before, before);
    }
    return displaced(force, tables);
  };
  RingMemory wide(*this);
  wide.now_ = widen(now_);
  for (Retarded& retarded : wide.retarded_) retarded = widen(retarded);
  wide.find_stored_energy();
  return wide;
}

void RingMemory::find_stored_energy() {
  stored_ = 0.5 * instantaneous_ * inner(now_.force, now_.displacement);
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    stored_ += 0.5 * weights_[j] * inner(retarded_[j].force, retarded_[j].displacement);
  }
}

}  // namespace viscoroll::detail
