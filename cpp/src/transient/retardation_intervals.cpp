#include "transient/retardation_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

/// Relative difference of times that are equal up to round-off.
constexpr double kSame = 1e-9;

/// Times at which a modulus changes its sign.
std::vector<double> changes(std::span<const CreepFunction> moduli) {
  std::vector<double> times;
  for (const CreepFunction& modulus : moduli) {
    const auto& own = modulus.creep.retardation_times;
    times.insert(times.end(), own.begin(), own.end());
    const auto poles = relaxation_times(modulus.creep);
    times.insert(times.end(), poles.begin(), poles.end());
  }
  std::ranges::sort(times);
  return times;
}

bool is_mixed(std::span<const CreepFunction> moduli, bool has_elastic_part, double time) {
  const auto is_negative = [time](const CreepFunction& modulus) { return modulus.at(time) < 0.0; };
  const bool all = !has_elastic_part && std::ranges::all_of(moduli, is_negative);
  return !all && std::ranges::any_of(moduli, is_negative);
}

/// Ascending intervals; intervals that touch are merged.
std::vector<TimeRange> joined(std::vector<TimeRange> intervals) {
  std::ranges::sort(intervals, {}, &TimeRange::shortest);
  std::vector<TimeRange> result;
  for (const TimeRange& interval : intervals) {
    if (result.empty() || interval.shortest > result.back().longest * (1.0 + kSame)) {
      result.push_back(interval);
    } else {
      result.back().longest = std::max(result.back().longest, interval.longest);
    }
  }
  return result;
}

}  // namespace

std::vector<TimeRange> retardation_intervals(std::span<const CreepFunction> moduli, bool has_elastic_part) {
  std::vector<TimeRange> intervals;
  const std::vector<double> times = changes(moduli);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (times[i + 1] <= times[i] * (1.0 + kSame)) continue;
    if (is_mixed(moduli, has_elastic_part, std::sqrt(times[i] * times[i + 1]))) {
      intervals.push_back({.shortest = times[i], .longest = times[i + 1]});
    }
  }
  for (const CreepFunction& modulus : moduli) {
    for (const double time : modulus.creep.retardation_times) intervals.push_back({.shortest = time, .longest = time});
  }
  return joined(std::move(intervals));
}

}  // namespace viscoroll::detail
