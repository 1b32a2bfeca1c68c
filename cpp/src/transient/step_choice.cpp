#include "transient/step_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscoroll::detail {
namespace {

constexpr double kGrowth = 1.1;
constexpr double kLargestLoadChange = 0.05;
constexpr double kFirstFraction = 1e-3;  // of a segment, if the material has even shorter times
constexpr double kFirstTime = 0.05;      // of the shortest retardation time

}  // namespace

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
  const double longest = segment.duration / std::max({by_turn, by_load, 1.0});
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

}  // namespace viscoroll::detail
