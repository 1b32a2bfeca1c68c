#include "transient/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace viscoroll::detail {
namespace {

/// Coefficients of a term for a step of z = duration / retardation time. For small z, power series replace the
/// differences of nearly equal numbers.
TimeStep::Term term_of(double weight, double z) {
  constexpr double kSmall = 1e-3;
  const double decay = std::exp(-z);
  const double creep = -std::expm1(-z);                 // 1 - decay
  const double mean_decay = z > 0.0 ? creep / z : 1.0;  // mean of e^-t over t < z
  const double on_new = z < kSmall ? z / 2.0 - z * z / 6.0 + z * z * z / 24.0 : 1.0 - mean_decay;
  const double on_old = creep - on_new;
  const double squared_decay = -0.5 * std::expm1(-2.0 * z);  // integral of e^-2t over t < z
  // Integral of (1 - e^-t)^2 over t < z, divided by z^2.
  const double ramp =
      z < kSmall ? z / 3.0 - z * z / 4.0 + 7.0 * z * z * z / 60.0 : (z - 2.0 * creep + squared_decay) / (z * z);
  return {.weight = weight,
          .decay = decay,
          .on_old = on_old,
          .on_new = on_new,
          .lost_change = weight * ramp,
          .lost_mixed = weight * creep * mean_decay,
          .lost_state = weight * squared_decay};
}

constexpr double kGrowth = 1.1;              // ratio of successive steps after an event
constexpr double kLargestLoadChange = 0.05;  // in a step, relative to the larger load
constexpr double kFirstFraction = 1e-3;      // of a segment, if the material has even shorter times
constexpr double kFirstTime = 0.05;          // of the shortest retardation time

void write_end(const StepEnd& end, NumberWriter& numbers) {
  numbers.put(std::vector<double>{end.time, end.angle, end.load});
  for (const std::optional<double>& given : {end.center_displacement, end.axle_height})
    numbers.put(given ? std::vector{*given} : std::vector<double>{});
}

StepEnd read_end(NumberReader& numbers) {
  const std::vector<double> values = numbers.values();
  NumberReader::require(values.size() == 3);
  StepEnd end{.time = values[0], .angle = values[1], .load = values[2], .center_displacement = {}};
  for (std::optional<double>* given : {&end.center_displacement, &end.axle_height}) {
    const std::vector<double> value = numbers.values();
    NumberReader::require(value.size() <= 1);
    if (!value.empty()) *given = value.front();
  }
  return end;
}

}  // namespace

TimeStep::TimeStep(const CreepSpectrum& spectrum, double duration) : compliance(spectrum.instantaneous) {
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    terms.push_back(term_of(spectrum.weights[j], duration / spectrum.retardation_times[j]));
    compliance += terms.back().weight * terms.back().on_new;
  }
}

double max_turn(double spacing, std::optional<int> steps_per_spacing) {
  constexpr double kMaxSteps = 1e7;  // their instants take some two gigabytes
  return steps_per_spacing ? kMaxSteps * spacing / *steps_per_spacing : std::numeric_limits<double>::infinity();
}

double relative_change(double before, double after) {
  const double larger = std::max(before, after);
  return larger > 0.0 ? (after - before) / larger : 0.0;
}

std::vector<double> StepChoice::fractions(const Segment& segment, double last) const {
  if (!steps_per_spacing_ || segment.duration == 0.0) return {1.0};
  constexpr double kRoundOff = 1e-9;
  const double by_turn = std::ceil(std::abs(segment.turn) * *steps_per_spacing_ / spacing_ - kRoundOff);
  const double by_load = std::ceil(std::abs(segment.relative_load) / kLargestLoadChange - kRoundOff);
  const double by_vibration = std::ceil(segment.duration / segment.longest_step - kRoundOff);
  const double longest = segment.duration / std::max({by_turn, by_load, by_vibration, 1.0});
  const double first = std::max(kFirstTime * shortest_time_, kFirstFraction * segment.duration);

  std::vector<double> ends;
  double end = 0.0;
  double step = std::min(std::max(kGrowth * last, first), longest);
  while (end < segment.duration * (1.0 - kRoundOff)) {
    end += step;
    ends.push_back(end);
    step = std::min(kGrowth * step, longest);
  }
  for (double& fraction : ends) fraction /= end;
  ends.back() = 1.0;
  return ends;
}

StepEnd StartedSegment::at(double share) const {
  StepEnd at{.time = begin.time + share * (end.time - begin.time),
             .angle = begin.angle + share * (end.angle - begin.angle),
             .load = begin.load + share * (end.load - begin.load),
             .center_displacement = {}};
  if (end.center_displacement) {
    at.center_displacement =
        *begin.center_displacement + share * (*end.center_displacement - *begin.center_displacement);
  }
  if (end.axle_height) at.axle_height = *begin.axle_height + share * (*end.axle_height - *begin.axle_height);
  return at;
}

void write(const std::optional<StartedSegment>& started, NumberWriter& numbers) {
  numbers.put(started ? 1.0 : 0.0);
  if (!started) return;
  write_end(started->begin, numbers);
  write_end(started->end, numbers);
  numbers.put(started->last_step);
  numbers.put(static_cast<double>(started->taken));
}

std::optional<StartedSegment> read_started_segment(NumberReader& numbers) {
  if (numbers.count(1.0) == 0) return std::nullopt;
  StartedSegment started{.begin = read_end(numbers), .end = read_end(numbers), .last_step = numbers.get(), .taken = 0};
  NumberReader::require(started.begin.center_displacement.has_value() && started.begin.axle_height.has_value());
  started.taken = static_cast<std::size_t>(numbers.count());
  return started;
}

}  // namespace viscoroll::detail
