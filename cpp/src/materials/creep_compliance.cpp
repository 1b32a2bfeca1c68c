#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <ranges>
#include <string>

#include "base/validate.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll {
namespace {

/// Retardation rates d_k = 1 / tau_k, ascending and distinct, with v_k^2 = J_k / (J_0 tau_k). The relaxation rates are
/// the roots of f(rate) = 1 + sum_k v_k^2 / (d_k - rate). One lies above each d_k and below the next one.
struct Rates {
  std::vector<double> retardation;
  std::vector<double> squares;

  /// f at retardation[pole] + offset; differences of rates are exact near this pole
  [[nodiscard]] double value(std::size_t pole, double offset) const {
    double sum = 1.0;
    for (std::size_t k = 0; k < squares.size(); ++k) sum += squares[k] / distance(k, pole, offset);
    return sum;
  }

  [[nodiscard]] double slope(std::size_t pole, double offset) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < squares.size(); ++k) sum += squares[k] / std::pow(distance(k, pole, offset), 2);
    return sum;
  }

  [[nodiscard]] double distance(std::size_t k, std::size_t pole, double offset) const {
    return (retardation[k] - retardation[pole]) - offset;
  }
};

/// Offset of a root from a pole: bisection of the logarithm of its magnitude, which may have any scale.
/// @param[in] sign side of the pole on which the root lies
/// @param[in] farthest bound of the magnitude
double root(const Rates& rates, std::size_t pole, double sign, double farthest) {
  constexpr double kNearest = 1e-200;  // fraction of the bound; a root so near a pole has a weight of this size
  double low = kNearest * farthest;
  double high = farthest;
  while (true) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    if (middle <= low || middle >= high) return sign * high;
    // f rises from -infinity above a pole to +infinity below the next one.
    const bool is_beyond = (rates.value(pole, sign * middle) > 0.0) == (sign > 0.0);
    (is_beyond ? high : low) = middle;
  }
}

}  // namespace

Prony creep_compliance(double instantaneous_compliance, std::span<const double> compliances,
                       std::span<const double> retardation_times) {
  using detail::require_positive;
  require_positive("instantaneous_compliance", instantaneous_compliance, "1/Pa");
  if (retardation_times.size() != compliances.size()) {
    detail::reject("retardation_times", "as many as compliances (" + std::to_string(compliances.size()) + ")",
                   std::to_string(retardation_times.size()));
  }
  std::map<double, double> by_time;  // terms with one retardation time are one term
  for (std::size_t k = 0; k < compliances.size(); ++k) {
    const std::string index = "[" + std::to_string(k) + "]";
    detail::require_nonnegative("compliances" + index, compliances[k], "1/Pa");
    require_positive("retardation_times" + index, retardation_times[k], "s");
    if (compliances[k] > 0.0) by_time[retardation_times[k]] += compliances[k];
  }

  Rates rates;
  for (const auto& [time, compliance] : by_time | std::views::reverse) {
    rates.retardation.push_back(1.0 / time);
    rates.squares.push_back(compliance / instantaneous_compliance / time);
  }
  const double total = std::accumulate(rates.squares.begin(), rates.squares.end(), 0.0);
  Prony series{.instantaneous_modulus = 1.0 / instantaneous_compliance};
  for (std::size_t k = 0; k < rates.squares.size(); ++k) {
    const bool is_last = k + 1 == rates.squares.size();
    const double gap = is_last ? 2.0 * total : rates.retardation[k + 1] - rates.retardation[k];
    // The offset is measured from the nearer pole.
    const bool is_near_next = !is_last && rates.value(k, 0.5 * gap) < 0.0;
    const std::size_t pole = is_near_next ? k + 1 : k;
    const double offset = root(rates, pole, is_near_next ? -1.0 : 1.0, is_last ? gap : 0.5 * gap);
    const double rate = rates.retardation[pole] + offset;
    series.weights.push_back(1.0 / (rates.slope(pole, offset) * rate));
    series.relaxation_times.push_back(1.0 / rate);
  }
  return series;
}

}  // namespace viscoroll
