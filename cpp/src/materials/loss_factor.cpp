#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/validate.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll {
namespace {

/// Relaxation times per decade. With only two, the sum over them would differ from the integral by a ripple of 3e-4.
constexpr double kTermsPerDecade = 3.0;

/// Decades by which the terms extend beyond the range in which the loss factor is nearly constant, at either end.
constexpr double kMargin = 1.0;

/// Prony series with moduli relative to sqrt(1 + tan^2 delta) modulus and times relative to 1 / reference_frequency.
struct Series {
  std::vector<double> moduli;
  std::vector<double> times;
  double relaxed = 0.0;
};

/// Series for (i w)^alpha, for `reach` decades above and below w = 1, from the spectrum
///
///     (i w)^alpha = sin(alpha pi) / pi  integral tau^-alpha i w tau / (1 + i w tau) d ln tau.
///
/// Terms with times longer than the grid contribute their full modulus at its frequencies: they form the relaxed
/// modulus. Their loss, the sum of w_k / (w tau_k), is represented by one term beyond the end of the grid. Terms with
/// shorter times contribute the loss w_k w tau_k, represented by one term before its start.
Series power_law(double alpha, double reach) {
  const double step = std::numbers::ln10 / kTermsPerDecade;
  const double count = std::nearbyint(2.0 * reach * kTermsPerDecade);
  const double density = std::sin(alpha * std::numbers::pi) / std::numbers::pi;
  const double last = 0.5 * step * count;  // ln tau of the last term on the grid; the first one has -last
  const double end = std::exp(last + 0.5 * step);
  const double beyond = std::exp(last + step);

  Series series;
  series.moduli.push_back(density * std::pow(end, alpha - 1.0) / (1.0 - alpha) * beyond);
  series.times.push_back(1.0 / beyond);
  for (int k = 0; k <= static_cast<int>(count); ++k) {
    series.times.push_back(std::exp(step * k - last));
    series.moduli.push_back(density * step * std::pow(series.times.back(), -alpha));
  }
  const double tail = density * std::pow(end, -alpha - 1.0) / (alpha + 1.0) * beyond;
  series.moduli.push_back(tail);
  series.times.push_back(beyond);
  series.relaxed = std::max(density * std::pow(end, -alpha) / alpha - tail, 0.0);
  return series;
}

}  // namespace

Prony loss_factor(const LossFactor& law) {
  detail::require_positive("modulus", law.modulus, "Pa");
  if (!(law.loss_factor >= 1e-6 && law.loss_factor <= 2.0)) {
    detail::reject("loss_factor", "in [1e-6, 2]", law.loss_factor);
  }
  detail::require_positive("reference_frequency", law.reference_frequency, "rad/s");
  if (!(law.decades >= 0.5 && law.decades <= 8.0)) detail::reject("decades", "in [0.5, 8]", law.decades);

  const Series series = power_law(2.0 / std::numbers::pi * std::atan(law.loss_factor), law.decades + kMargin);
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
