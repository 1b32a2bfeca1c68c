#include "transient/row_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// Since a row bore a load; finite, for states are.
constexpr double kNever = std::numeric_limits<double>::max();

double inner(const HalfField& a, const HalfField& b) { return a.cwiseProduct(b).sum(); }

/// When the share of what is retarded that is left has fallen to a millionth, about what a table's far end is cut at.
double fading_time(const CreepSpectrum& spectrum) {
  constexpr double kForgotten = 1e-6;
  if (spectrum.size() == 0) return 0.0;
  double all = 0.0;
  double longest = 0.0;
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    all += spectrum.weights[j];
    longest = std::max(longest, spectrum.retardation_times[j]);
  }
  const auto left = [&](double time) {
    double sum = 0.0;
    for (std::size_t j = 0; j < spectrum.size(); ++j) {
      sum += spectrum.weights[j] / all * std::exp(-time / spectrum.retardation_times[j]);
    }
    return sum;
  };
  double low = 0.0;
  double high = -std::log(kForgotten) * longest;  // where even the slowest term alone has fallen to it
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (left(middle) > kForgotten ? low : high) = middle;
  }
  return high;
}

}  // namespace

RowMemory::RowMemory(const CreepingBody& body)
    : ring_(body.ring),
      instantaneous_(body.spectrum.instantaneous),
      weights_(body.spectrum.weights),
      fading_(fading_time(body.spectrum)),
      reach_(body.tables.reach()) {
  const HalfField zero = HalfField::Zero(body.tables.height(), ring_.value_or(0));
  now_ = {zero, zero};
  retarded_.assign(body.spectrum.size(), now_);
}

std::optional<Index> RowMemory::column(Index row) const {
  if (ring_) return ((row % *ring_) + *ring_) % *ring_;
  const Index column = row - first_;
  return column >= 0 && column < rows() ? std::optional(column) : std::nullopt;
}

void RowMemory::cover(Index first, Index count) {
  if (ring_) return;
  if (rows() == 0) first_ = first;
  const Index low = std::min(first, first_);
  const Index high = std::max(first + count, first_ + rows());
  if (low < first_ || high > first_ + rows()) keep(low - first_, high - low);
}

void RowMemory::keep(Index first, Index count) {
  const Index from = std::max<Index>(first, 0);
  const Index kept = std::min(first + count, rows()) - from;
  const auto moved = [&](HalfField& field) {
    HalfField next = HalfField::Zero(field.rows(), count);
    if (kept > 0) next.middleCols(from - first, kept) = field.middleCols(from, kept);
    field = std::move(next);
  };
  Eigen::ArrayXd idle = Eigen::ArrayXd::Constant(count, kNever);
  if (kept > 0) idle.segment(from - first, kept) = idle_.segment(from, kept);
  idle_ = std::move(idle);
  for (Retarded& retarded : retarded_) {
    moved(retarded.force);
    moved(retarded.displacement);
  }
  moved(now_.force);
  moved(now_.displacement);
  first_ += first;
}

std::optional<RowMemory::Span> RowMemory::living() const {
  Index first = 0;
  Index last = idle_.size() - 1;
  while (first <= last && idle_[first] > fading_) ++first;
  while (last >= first && idle_[last] > fading_) --last;
  if (first > last) return std::nullopt;
  return Span{.first = first_ + first, .last = first_ + last};
}

void RowMemory::age(double duration, const Load& load) {
  if (ring_) return;
  idle_ += duration;
  for (Index i = 0; i < load.force.cols(); ++i) {
    if ((load.force.col(i).array() != 0.0).any()) idle_[load.first + i - first_] = 0.0;
  }
}

double RowMemory::forget(const Load& load) {
  if (ring_) return 0.0;
  const Span window{.first = load.first, .last = load.first + load.force.cols() - 1};
  const Span alive = living().value_or(window);
  const Index first = std::max(std::min(alive.first - reach_, window.first), first_) - first_;
  const Index last = std::min(std::max(alive.last + reach_, window.last), first_ + rows() - 1) - first_;
  double lost = 0.0;
  for (Index column = 0; column < rows(); ++column) {
    if (column < first || column > last) lost += stored_in(column);
  }
  if (first > 0 || last < rows() - 1) keep(first, last - first + 1);
  stored_ -= lost;
  return lost;
}

double RowMemory::stored_in(Index column) const {
  double stored = 0.5 * instantaneous_ * now_.force.col(column).dot(now_.displacement.col(column));
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    stored += 0.5 * weights_[j] * retarded_[j].force.col(column).dot(retarded_[j].displacement.col(column));
  }
  return stored;
}

void RowMemory::set(const Load& load, Retarded& field) const {
  field.force = HalfField::Zero(load.force.rows(), rows());
  field.displacement = field.force;
  // Rows within reach may go around a ring more than once.
  for (Index i = 0; i < load.force.cols(); ++i) {
    const auto place = column(load.first + i);
    if (!place) continue;
    field.force.col(*place) += load.force.col(i);
    field.displacement.col(*place) += load.displacement.col(i);
  }
}

void RowMemory::relax(const Load& load) {
  cover(load.first, load.force.cols());
  age(0.0, load);
  set(load, now_);
  std::ranges::fill(retarded_, now_);
  find_stored_energy();
}

void RowMemory::press(const Load& load) {
  cover(load.first, load.force.cols());
  age(0.0, load);
  set(load, now_);
  find_stored_energy();
}

double RowMemory::advance(const TimeStep& step, double duration, const Load& load) {
  cover(load.first, load.force.cols());
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
    for (Index row = 0; row < rows(); ++row) {
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
  age(duration, load);
  return lost + forget(load);
}

HalfField RowMemory::known_displacement(const TimeStep& step, Index first, Index count) const {
  HalfField known = HalfField::Zero(now_.force.rows(), count);
  double on_old = 0.0;
  for (const TimeStep::Term& term : step.terms) on_old += term.weight * term.on_old;
  for (Index i = 0; i < count; ++i) {
    const auto place = column(first + i);
    if (!place) continue;
    known.col(i) = on_old * now_.displacement.col(*place);
    for (std::size_t j = 0; j < retarded_.size(); ++j) {
      known.col(i) += step.terms[j].weight * step.terms[j].decay * retarded_[j].displacement.col(*place);
    }
  }
  return known;
}

HalfField RowMemory::displacement(Index first, Index count) const {
  HalfField field = HalfField::Zero(now_.force.rows(), count);
  for (Index i = 0; i < count; ++i) {
    const auto place = column(first + i);
    if (!place) continue;
    field.col(i) = instantaneous_ * now_.displacement.col(*place);
    for (std::size_t j = 0; j < retarded_.size(); ++j) {
      field.col(i) += weights_[j] * retarded_[j].displacement.col(*place);
    }
  }
  return field;
}

RowMemory::Retarded RowMemory::displaced(const HalfField& force, const MirroredTables& tables) const {
  const Index reach = tables.reach();
  Load load{.first = first_ - reach,
            .force = HalfField::Zero(tables.height(), rows() + 2 * reach),
            .displacement = tables.displacement_in_reach(force, 0, rows() - 1)};
  load.force.middleCols(reach, rows()) = force;
  Retarded result;
  set(load, result);
  return result;
}

void RowMemory::write(NumberWriter& numbers) const {
  numbers.put(static_cast<double>(first_));
  numbers.put(idle_.matrix());
  numbers.put(now_.force);
  for (const Retarded& retarded : retarded_) numbers.put(retarded.force);
}

void RowMemory::read(NumberReader& numbers, const MirroredTables& tables) {
  first_ = numbers.row();
  idle_ = numbers.matrix().reshaped();
  const Index expected = ring_ ? *ring_ : idle_.size();
  now_.force = HalfField::Zero(tables.height(), expected);
  const auto field = [&] {
    const HalfField force = numbers.matrix();
    if (force.rows() != tables.height() || force.cols() != expected) {
      reject("start", "a state of the same mesh", "one of another mesh");
    }
    return displaced(force, tables);
  };
  now_ = field();
  for (Retarded& retarded : retarded_) retarded = field();
  find_stored_energy();
}

RowMemory RowMemory::widened(const MirroredTables& tables) const {
  RowMemory wide(*this);
  wide.reach_ = tables.reach();
  // What is displaced from farther away, now that tables tell, was not kept yet.
  if (const auto alive = living()) {
    wide.cover(alive->first - wide.reach_, alive->last - alive->first + 1 + 2 * wide.reach_);
  }
  const Index components = tables.components();
  const Index before = now_.force.rows() / components;
  const auto widen = [&](Retarded& field) {
    HalfField force = HalfField::Zero(tables.height(), wide.rows());
    for (Index component = 0; component < components; ++component) {
      force.middleRows(component * tables.half_nodes(), before) = field.force.middleRows(component * before, before);
    }
    field = wide.displaced(force, tables);
  };
  widen(wide.now_);
  for (Retarded& retarded : wide.retarded_) widen(retarded);
  wide.find_stored_energy();
  return wide;
}

void RowMemory::find_stored_energy() {
  stored_ = 0.5 * instantaneous_ * inner(now_.force, now_.displacement);
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    stored_ += 0.5 * weights_[j] * inner(retarded_[j].force, retarded_[j].displacement);
  }
}

}  // namespace viscoroll::detail
