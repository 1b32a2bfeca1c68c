#include "viscoroll/slow_terms.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/invalid_speed.hpp"
#include "base/validate.hpp"

namespace viscoroll {
namespace {

using detail::rounded;

/// Smallest relaxed fraction of a modulus. The sum of weights that are meant to add up to 1 has a larger round-off.
constexpr double kLeastFraction = 1e-12;

double relaxed_fraction_of(const Prony& series) {
  return std::max(0.0, 1.0 - std::accumulate(series.weights.begin(), series.weights.end(), 0.0));
}

/// Reject a series that is a liquid at this speed.
void require_modulus_at_rest(const Prony& series, double angular_speed) {
  if (series.weights.empty() || relaxed_fraction_of(series) > kLeastFraction) return;
  const double longest = std::ranges::max(series.relaxation_times);
  throw detail::InvalidSpeed(
      angular_speed, {.before = ">= ",
                      .bound = detail::SpeedRule::Bound::minimum,
                      .limit = kSlowTerm / longest,
                      .after = " for a Prony series whose weights add up to 1, so that its slowest term, of " +
                               rounded(longest) + " s, does not relax; or the weights must add up to less than 1"});
}

}  // namespace

std::optional<SlowTerms> slow_terms(const ShearModulus& modulus, double angular_speed) {
  const auto* series = std::get_if<Prony>(&modulus);
  if (series == nullptr || series->weights.size() != series->relaxation_times.size()) return std::nullopt;
  SlowTerms slow{
      .count = 0, .shortest_time = std::numeric_limits<double>::infinity(), .modulus = 0.0, .modulus_at_rest = 0.0};
  double weight = 0.0;
  for (std::size_t k = 0; k < series->weights.size(); ++k) {
    if (!(series->weights[k] > 0.0 && angular_speed * series->relaxation_times[k] >= kSlowTerm)) continue;
    ++slow.count;
    slow.shortest_time = std::min(slow.shortest_time, series->relaxation_times[k]);
    weight += series->weights[k];
  }
  if (slow.count == 0) return std::nullopt;
  slow.modulus = series->instantaneous_modulus * weight;
  slow.modulus_at_rest = series->instantaneous_modulus * (relaxed_fraction_of(*series) + weight);
  return slow;
}

std::vector<std::complex<double>> modulus_in_rolling(const ShearModulus& modulus, double angular_speed,
                                                     std::span<const double> omega) {
  validate(modulus);
  const auto slow = slow_terms(modulus, angular_speed);
  if (!slow) {
    const auto* series = std::get_if<Prony>(&modulus);
    if (series != nullptr && std::ranges::find(omega, 0.0) != omega.end())
      require_modulus_at_rest(*series, angular_speed);
    return complex_modulus(modulus, omega);
  }
  std::vector<double> positive(omega.begin(), omega.end());
  std::ranges::replace(positive, 0.0, angular_speed);  // a series without relaxed modulus has no value at rest
  std::vector<std::complex<double>> values = complex_modulus(modulus, positive);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (omega[i] == 0.0) values[i] = slow->modulus_at_rest;
  }
  return values;
}

}  // namespace viscoroll
