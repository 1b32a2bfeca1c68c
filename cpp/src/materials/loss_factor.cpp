#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "materials/long_tests.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll {
namespace {

using detail::LongTest;
using detail::RelaxingTerms;

/// Relaxation times per decade. With only two, the sum over them would differ from the integral by a ripple of 3e-4.
constexpr double kTermsPerDecade = 3.0;

/// Decades by which the terms extend beyond the range in which the loss factor is nearly constant, at either end.
constexpr double kMargin = 1.0;

/// Series for (i w)^alpha, for `reach` decades above and below w = 1, from the spectrum
///
///     (i w)^alpha = sin(alpha pi) / pi  integral tau^-alpha i w tau / (1 + i w tau) d ln tau.
///
/// Terms with times longer than the grid contribute their full modulus at its frequencies: they form the relaxed
/// modulus. Their loss, the sum of w_k / (w tau_k), is represented by one term beyond the end of the grid, unless the
/// relaxation `continues` there. Terms with shorter times contribute the loss w_k w tau_k, represented by one term
/// before its start. Moduli are relative to sqrt(1 + tan^2 delta) modulus and times to 1 / reference_frequency.
RelaxingTerms power_law(double alpha, double reach, bool continues) {
  const double step = std::numbers::ln10 / kTermsPerDecade;
  const double count = std::nearbyint(2.0 * reach * kTermsPerDecade);
  const double density = std::sin(alpha * std::numbers::pi) / std::numbers::pi;
  const double last = 0.5 * step * count;  // ln tau of the last term on the grid; the first one has -last
  const double end = std::exp(last + 0.5 * step);
  const double beyond = std::exp(last + step);

  RelaxingTerms series;
  series.moduli.push_back(density * std::pow(end, alpha - 1.0) / (1.0 - alpha) * beyond);
  series.times.push_back(1.0 / beyond);
  for (int k = 0; k <= static_cast<int>(count); ++k) {
    series.times.push_back(std::exp(step * k - last));
    series.moduli.push_back(density * step * std::pow(series.times.back(), -alpha));
  }
  series.relaxed = density * std::pow(end, -alpha) / alpha;
  if (continues) return series;
  const double tail = density * std::pow(end, -alpha - 1.0) / (alpha + 1.0) * beyond;
  series.moduli.push_back(tail);
  series.times.push_back(beyond);
  series.relaxed = std::max(series.relaxed - tail, 0.0);
  return series;
}

/// Series whose relaxed modulus relaxes as (t / first)^-beta from the time `first` to `last`.
RelaxingTerms continued(RelaxingTerms series, double beta, double first, double last) {
  const double modulus = series.relaxed;
  const double span = std::log(last / first);
  const auto count = static_cast<int>(std::ceil(span / std::numbers::ln10 * kTermsPerDecade));
  const double step = span / count;
  for (int k = 0; k < count; ++k) {
    series.times.push_back(first * std::exp((k + 0.5) * step));
    series.moduli.push_back(-modulus * std::exp(-beta * step * k) * std::expm1(-beta * step));
  }
  series.relaxed = modulus * std::exp(-beta * span);
  return series;
}

/// Measurement over long times that determines the exponent of the slow relaxation.
struct LongTimes {
  const char* name;   ///< parameter with the measured value
  double value;       ///< measured value
  double shortest;    ///< shortest time of the test [s]
  double longest;     ///< its longest time [s]
  const char* limit;  ///< parameter with this time
  std::function<double(const LongTest&)> predict;
};

double given_with(const char* name, const std::optional<double>& value, const char* other) {
  if (!value) throw InvalidInput(name, std::string("must be given with ") + other, "");
  detail::require_positive(name, *value, "s");
  return *value;
}

void require_absent(const char* name, const std::optional<double>& value, const char* condition) {
  if (value) detail::reject(name, std::string("left out ") + condition, *value);
}

/// @return the measurement over long times, or none
std::optional<LongTimes> long_times(const LossFactor& law) {
  constexpr double kRecovery = 1800.0;  // s, of ISO 815
  if (law.compression_set) {
    for (const auto& [name, value] :
         {std::pair{"creep_ratio", law.creep_ratio}, std::pair{"creep_time", law.creep_time},
          std::pair{"creep_start", law.creep_start}}) {
      require_absent(name, value, "with compression_set");
    }
    const double set = *law.compression_set;
    if (!(set > 0.0 && set < 1.0)) {
      std::string given = detail::text(set);
      if (set >= 1.0 && set < 100.0) given += "; " + given + " % is " + detail::text(set / 100.0);
      detail::reject("compression_set", "in (0, 1), as a fraction of the compression", given);
    }
    const double duration = given_with("compression_time", law.compression_time, "compression_set");
    const double recovery = law.recovery_time.value_or(kRecovery);
    detail::require_positive("recovery_time", recovery, "s");
    return LongTimes{
        "compression_set", set, std::min(duration, recovery), duration, "compression_time", [=](const LongTest& test) {
          return test.compression_set(duration, recovery);
        }};
  }
  require_absent("compression_time", law.compression_time, "without compression_set");
  require_absent("recovery_time", law.recovery_time, "without compression_set");
  if (!law.creep_ratio) {
    require_absent("creep_time", law.creep_time, "without creep_ratio");
    require_absent("creep_start", law.creep_start, "without creep_ratio");
    return std::nullopt;
  }
  detail::require_in({.minimum = 1.0, .excludes_minimum = true}, "creep_ratio", *law.creep_ratio);
  const double start = given_with("creep_start", law.creep_start, "creep_ratio");
  const double time = given_with("creep_time", law.creep_time, "creep_ratio");
  if (!(time > start)) {
    detail::reject("creep_time", "> creep_start = " + detail::text(start) + " s", time,
                   Range{.unit = "s", .minimum = start, .excludes_minimum = true});
  }
  return LongTimes{"creep_ratio", *law.creep_ratio,
                   start,         time,
                   "creep_time",  [=](const LongTest& test) { return test.creep(time) / test.creep(start); }};
}

/// Series with the slow relaxation for which a test over long times gives the measured value.
RelaxingTerms with_long_times(const RelaxingTerms& series, const LongTimes& measured, double first, double unit) {
  const double last = measured.longest / unit;
  detail::require_in({.unit = "s", .minimum = first * unit, .excludes_minimum = true}, measured.limit, measured.longest,
                     " = 10^(decades + 1) / reference_frequency, where the loss factor ends; reduce decades");
  const auto value = [&](double beta) {
    RelaxingTerms terms = continued(series, beta, first, last);
    for (double& time : terms.times) time *= unit;
    return measured.predict(LongTest(terms, measured.shortest));
  };
  double low = 0.0;
  double high = 1.0;  // a faster relaxation is that of a liquid
  const auto [least, most] = std::pair{value(low), value(high)};
  detail::require_in({.minimum = least, .maximum = most}, measured.name, measured.value,
                     " for this loss factor and these times");
  for (int bisection = 0; bisection < 50; ++bisection) {  // to double precision
    const double middle = 0.5 * (low + high);
    (value(middle) < measured.value ? low : high) = middle;
  }
  return continued(series, 0.5 * (low + high), first, last);
}

}  // namespace

Prony loss_factor(const LossFactor& law) {
  detail::require_positive("modulus", law.modulus, "Pa");
  detail::require_in({.minimum = 1e-6, .maximum = 2.0}, "loss_factor", law.loss_factor);
  detail::require_positive("reference_frequency", law.reference_frequency, "rad/s");
  detail::require_in({.minimum = 0.5, .maximum = 8.0}, "decades", law.decades);

  const std::optional<LongTimes> measured = long_times(law);
  const double reach = law.decades + kMargin;
  const double unit = 1.0 / law.reference_frequency;
  RelaxingTerms series = power_law(2.0 / std::numbers::pi * std::atan(law.loss_factor), reach, measured.has_value());
  if (measured) series = with_long_times(series, *measured, std::pow(10.0, reach), unit);
  const double relaxing = std::accumulate(series.moduli.begin(), series.moduli.end(), 0.0);
  const double total = relaxing + series.relaxed;
  double storage = series.relaxed;  // at the reference frequency
  Prony prony;
  for (std::size_t k = 0; k < series.moduli.size(); ++k) {
    const double square = series.times[k] * series.times[k];
    storage += series.moduli[k] * square / (1.0 + square);
    prony.weights.push_back(series.moduli[k] / total);
    prony.relaxation_times.push_back(series.times[k] / law.reference_frequency);
  }
  // The modulus at rest, 1 minus the sum of the weights, may be 1e-4: the largest weight takes up the round-off
  // of the sum.
  const double sum = std::accumulate(prony.weights.begin(), prony.weights.end(), 0.0);
  *std::ranges::max_element(prony.weights) += relaxing / total - sum;
  prony.instantaneous_modulus = law.modulus * total / storage;
  return prony;
}

}  // namespace viscoroll
