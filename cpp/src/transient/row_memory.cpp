#include "transient/row_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// Time since the last load of a row that was never loaded; finite, because numbers of states are finite.
constexpr double kNever = std::numeric_limits<double>::max();

double inner(const HalfField& a, const HalfField& b) { return a.cwiseProduct(b).sum(); }

/// Relaxed displacement of each retardation time of a body at the place of a unit force.
std::vector<double> sizes_of(const ViscoelasticBody& body) {
  std::vector<double> sizes;
  sizes.reserve(body.spectrum.size());
  for (std::size_t j = 0; j < body.spectrum.size(); ++j) {
    sizes.push_back(body.spectrum.weights[j] *
                    std::abs(body.tables.all()[body.tables.of_term(j)].diagonal_compliance()));
  }
  return sizes;
}

/// Time in which all but a millionth of the retarded displacement recovers. Tables that fall to this fraction count as
/// decayed.
double fading_time(const ViscoelasticBody& body) {
  constexpr double kForgotten = 1e-6;
  const CreepSpectrum& spectrum = body.spectrum;
  if (spectrum.size() == 0) return 0.0;
  const std::vector<double> sizes = sizes_of(body);
  double all = 0.0;
  double longest = 0.0;
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    all += sizes[j];
    longest = std::max(longest, spectrum.retardation_times[j]);
  }
  const auto left = [&](double time) {
    double sum = 0.0;
    for (std::size_t j = 0; j < spectrum.size(); ++j) {
      sum += sizes[j] / all * std::exp(-time / spectrum.retardation_times[j]);
    }
    return sum;
  };
  double low = 0.0;
  double high = -std::log(kForgotten) * longest;  // at which the slowest term alone has decayed to it
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (left(middle) > kForgotten ? low : high) = middle;
  }
  return high;
}

}  // namespace

RowMemory::RowMemory(const ViscoelasticBody& body)
    : ring_(body.ring),
      instantaneous_(body.spectrum.instantaneous),
      weights_(body.spectrum.weights),
      fading_(fading_time(body)),
      reach_(body.tables.reach()) {
  const HalfField zero = HalfField::Zero(body.tables.height(), ring_.value_or(0));
  now_ = {.force = zero, .displacements = std::vector(body.tables.count(), zero)};
  retarded_.assign(body.spectrum.size(), {.force = zero, .displacement = zero});
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
  for (HalfField& displacement : now_.displacements) moved(displacement);
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
  double stored = 0.5 * instantaneous_ * now_.force.col(column).dot(now_.displacements.front().col(column));
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    stored += 0.5 * weights_[j] * retarded_[j].force.col(column).dot(retarded_[j].displacement.col(column));
  }
  return stored;
}

HalfField RowMemory::spread(Index first, const HalfField& field) const {
  HalfField all = HalfField::Zero(field.rows(), rows());
  // Rows within reach may go around a ring more than once.
  for (Index i = 0; i < field.cols(); ++i) {
    if (const auto place = column(first + i)) all.col(*place) += field.col(i);
  }
  return all;
}

RowMemory::LoadedDisplacements RowMemory::spread(const Load& load) const {
  LoadedDisplacements loaded_displacements{.force = spread(load.first, load.force), .displacements = {}};
  for (const HalfField& field : load.displacements)
    loaded_displacements.displacements.push_back(spread(load.first, field));
  return loaded_displacements;
}

void RowMemory::relax(const Load& load) {
  cover(load.first, load.force.cols());
  age(0.0, load);
  now_ = spread(load);
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    retarded_[j] = {.force = now_.force, .displacement = now_.displacements[table_of(j)]};
  }
  find_stored_energy();
}

void RowMemory::press(const Load& load) {
  cover(load.first, load.force.cols());
  age(0.0, load);
  now_ = spread(load);
  find_stored_energy();
}

double RowMemory::advance(const TimeStep& step, double duration, const Load& load) {
  cover(load.first, load.force.cols());
  LoadedDisplacements next = spread(load);
  const HalfField change = next.force - now_.force;
  std::vector<double> changed;
  changed.reserve(next.displacements.size());
  for (std::size_t t = 0; t < next.displacements.size(); ++t) {
    changed.push_back(inner(change, next.displacements[t] - now_.displacements[t]));
  }
  double lost = 0.0;
  stored_ = 0.5 * instantaneous_ * inner(next.force, next.displacements.front());
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    const TimeStep::Term& term = step.terms[j];
    const HalfField& old_displacement = now_.displacements[table_of(j)];
    const HalfField& new_displacement = next.displacements[table_of(j)];
    auto& [force, displacement] = retarded_[j];
    double mixed = 0.0;
    double state = 0.0;
    double stored = 0.0;
    for (Index row = 0; row < rows(); ++row) {
      const auto behind = (old_displacement.col(row) - displacement.col(row)).eval();
      mixed += change.col(row).dot(behind);
      state += (now_.force.col(row) - force.col(row)).dot(behind);
      force.col(row) =
          term.decay * force.col(row) + term.on_old * now_.force.col(row) + term.on_new * next.force.col(row);
      displacement.col(row) = term.decay * displacement.col(row) + term.on_old * old_displacement.col(row) +
                              term.on_new * new_displacement.col(row);
      stored += force.col(row).dot(displacement.col(row));
    }
    lost += term.lost_change * changed[table_of(j)] + term.lost_mixed * mixed + term.lost_state * state;
    stored_ += 0.5 * term.weight * stored;
  }
  now_ = std::move(next);
  age(duration, load);
  return lost + forget(load);
}

HalfField RowMemory::known_displacement(const TimeStep& step, Index first, Index count) const {
  HalfField known = HalfField::Zero(now_.force.rows(), count);
  std::vector<double> on_old(now_.displacements.size(), 0.0);
  for (std::size_t j = 0; j < step.terms.size(); ++j) {
    on_old[table_of(j)] += step.terms[j].weight * step.terms[j].on_old;
  }
  for (Index i = 0; i < count; ++i) {
    const auto place = column(first + i);
    if (!place) continue;
    for (std::size_t t = 0; t < on_old.size(); ++t) {
      if (on_old[t] != 0.0) known.col(i) += on_old[t] * now_.displacements[t].col(*place);
    }
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
    field.col(i) = instantaneous_ * now_.displacements.front().col(*place);
    for (std::size_t j = 0; j < retarded_.size(); ++j) {
      field.col(i) += weights_[j] * retarded_[j].displacement.col(*place);
    }
  }
  return field;
}

HalfField RowMemory::displaced(const HalfField& force, const MirroredTables& tables,
                               const std::function<void()>& checkpoint) const {
  return spread(first_ - tables.reach(), tables.displacement_in_reach(force, 0, rows() - 1, checkpoint));
}

void RowMemory::displace(const CreepTables& tables, const std::function<void()>& checkpoint) {
  for (std::size_t t = 0; t < tables.count(); ++t) {
    now_.displacements[t] = displaced(now_.force, tables.all()[t], checkpoint);
  }
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    retarded_[j].displacement = displaced(retarded_[j].force, tables.all()[tables.of_term(j)], checkpoint);
  }
  find_stored_energy();
}

void RowMemory::write(NumberWriter& numbers) const {
  numbers.put(static_cast<double>(first_));
  numbers.put(idle_.matrix());
  numbers.put(now_.force);
  for (const HalfField& displacement : now_.displacements) numbers.put(displacement);
  for (const Retarded& retarded : retarded_) {
    numbers.put(retarded.force);
    numbers.put(retarded.displacement);
  }
  numbers.put(stored_);
}

void RowMemory::read(NumberReader& numbers, const CreepTables& tables) {
  first_ = numbers.row();
  idle_ = numbers.matrix().reshaped();
  const Index expected = ring_ ? *ring_ : idle_.size();
  const auto field = [&] {
    HalfField values = numbers.matrix();
    if (values.rows() != tables.height() || values.cols() != expected) {
      reject("start", "a state of the same mesh", "a state of another mesh");
    }
    return values;
  };
  now_.force = field();
  for (HalfField& displacement : now_.displacements) displacement = field();
  for (Retarded& retarded : retarded_) {
    retarded.force = field();
    retarded.displacement = field();
  }
  stored_ = numbers.get();
}

RowMemory RowMemory::widened(const CreepTables& tables, const std::function<void()>& checkpoint) const {
  RowMemory wide(*this);
  wide.reach_ = tables.reach();
  // Rows that only the larger tables reach have not been stored before.
  if (const auto alive = living()) {
    wide.cover(alive->first - wide.reach_, alive->last - alive->first + 1 + 2 * wide.reach_);
  }
  const Index components = tables.components();
  const Index before = now_.force.rows() / components;
  const auto widen = [&](HalfField& force) {
    HalfField more = HalfField::Zero(tables.height(), wide.rows());
    for (Index component = 0; component < components; ++component) {
      more.middleRows(component * tables.half_nodes(), before) = force.middleRows(component * before, before);
    }
    force = std::move(more);
  };
  widen(wide.now_.force);
  for (Retarded& retarded : wide.retarded_) widen(retarded.force);
  wide.displace(tables, checkpoint);
  return wide;
}

void RowMemory::find_stored_energy() {
  stored_ = 0.5 * instantaneous_ * inner(now_.force, now_.displacements.front());
  for (std::size_t j = 0; j < retarded_.size(); ++j) {
    stored_ += 0.5 * weights_[j] * inner(retarded_[j].force, retarded_[j].displacement);
  }
}

}  // namespace viscoroll::detail
