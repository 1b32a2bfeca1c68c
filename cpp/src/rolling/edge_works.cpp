#include "rolling/edge_works.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "base/validate.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll::detail {
namespace {

using std::numbers::pi;

/// Length at which an increasing function of it, approximately a power, has a value: the rule of Illinois in
/// logarithms.
/// @param[in] guess length of about the right order [m]
template <class Function>
double length_at(double value, double guess, const Function& function) {
  constexpr double kTolerance = 1e-13;
  constexpr int kMaxSteps = 200;  // the rule of Illinois needs about ten
  const auto excess = [&](double log_length) { return std::log(function(std::exp(log_length)) / value); };
  double low = std::log(guess);
  double high = low;
  double at_low = excess(low);
  double at_high = at_low;
  while (at_low > 0.0) at_low = excess(low -= 1.0);
  while (at_high < 0.0) at_high = excess(high += 1.0);
  for (int step = 0; step < kMaxSteps && at_high > 0.0 && at_low < 0.0; ++step) {
    const double middle = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_middle = excess(middle);
    if (std::abs(at_middle) <= kTolerance) return std::exp(middle);
    if (at_middle < 0.0) {
      low = middle;
      at_low = at_middle;
      at_high *= 0.5;
    } else {
      high = middle;
      at_high = at_middle;
      at_low *= 0.5;
    }
  }
  return std::exp(at_low == 0.0 ? low : high);
}

/// Length of a zone with a given strength and work.
/// @param[in] edge edge for a time of passage [s]
template <class Edge>
double zone_length(const EdgeCreep& creep, double work, double strength, double speed, const Edge& edge) {
  const double squared = strength * strength;
  const double guess = work / (squared * edge(creep, std::numeric_limits<double>::infinity(), 0.0).work);
  return length_at(work, guess,
                   [&](double length) { return squared * length * edge(creep, length / speed, 0.0).work; });
}

/// Law of a zone with a given stress intensity.
/// @param[in] edge edge of unit length and unit peak
EdgeLaw law_of(const CohesiveEdge& edge, double intensity, double zone) {
  const double peak = intensity / (edge.intensity * std::sqrt(zone));
  return {.peak = peak, .work = peak * peak * zone * edge.work};
}

/// 1/E* = (1 - nu) / (2 G) of a layer [1/Pa], or the same in terms of its bulk modulus.
/// @param[in] modulus shear modulus G, may be infinite [Pa]
double edge_compliance(const Layer& layer, double modulus) {
  if (layer.bulk_modulus) return 0.25 / modulus + 0.25 / (*layer.bulk_modulus + modulus / 3.0);
  return 0.5 * (1.0 - *layer.poisson_ratio) / modulus;
}

/// Reject an infinite strength if the stress intensities depend on the strength.
void require_strength(const EdgeCreep& creep) {
  constexpr double kWidestSpectrum = 100.0;  // ratio of retardation times
  constexpr auto kParameter = "adhesion.strength";
  constexpr auto kGiven = "none, which is an infinite strength";
  if (creep.instantaneous <= 0.0) {
    reject(kParameter, "given in Pa, or the range in m, for a material without instantaneous compliance", kGiven);
  }
  if (creep.retardation_times.empty()) return;
  const auto [shortest, longest] = std::ranges::minmax(creep.retardation_times);
  if (longest > kWidestSpectrum * shortest) {
    reject(kParameter,
           "given in Pa, or the range in m, for a material with retardation times from " + rounded(shortest) + " to " +
               rounded(longest) + " s, because the work of separation depends on it",
           kGiven);
  }
}

}  // namespace

EdgeCreep edge_creep(const RollingPair& pair, const TimeRange& range) {
  EdgeCreep creep;
  for (const Body* body : std::array<const Body*, 2>{pair.body.get(), pair.on.get()}) {
    if (body->is_rigid()) continue;
    const Layer& layer = body->layers().back().layer;
    const double modulus = complex_modulus(layer.shear_modulus, std::array{0.0}).front().real();
    const CreepSpectrum spectrum = creep_spectrum(layer.shear_modulus, range);
    const double relaxed = edge_compliance(layer, modulus);
    const double instantaneous = edge_compliance(layer, modulus / spectrum.instantaneous);
    const double total = std::accumulate(spectrum.weights.begin(), spectrum.weights.end(), 0.0);
    creep.instantaneous += instantaneous;
    for (std::size_t j = 0; j < spectrum.size(); ++j) {
      creep.delayed.push_back((relaxed - instantaneous) * spectrum.weights[j] / total);
      creep.retardation_times.push_back(spectrum.retardation_times[j]);
    }
  }
  return creep;
}

EdgeIntensities edge_intensities(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double speed) {
  const auto& [separation, bonding, strength] = adhesion;
  if (std::isinf(strength)) {
    require_strength(creep);
    const double compliance = speed == 0.0 ? creep.relaxed() : creep.instantaneous;
    return {.opening = std::sqrt(2.0 * separation / compliance),
            .closing = std::sqrt(2.0 * bonding * compliance),
            .opening_zone = 0.0,
            .closing_zone = 0.0};
  }
  const double opening = zone_length(creep, separation, strength, speed, opening_edge);
  const double closing = zone_length(creep, bonding, strength, speed, closing_edge);
  return {.opening = strength * std::sqrt(opening) * opening_edge(creep, opening / speed).intensity,
          .closing = strength * std::sqrt(closing) * closing_edge(creep, closing / speed).intensity,
          .opening_zone = opening,
          .closing_zone = closing};
}

EdgeLaws edge_laws(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, const EdgeIntensities& edges, double zone,
                   double speed, const ContactSize& contact) {
  // The pressure of a contact of Hertz's shape between two edges is p sqrt(1 - t^2) = b_0 + b_1 t + b_2 (2 t^2 - 1),
  // and its values at t = -1 and 1 are the tensions K / sqrt(pi a).
  const double root = std::sqrt(pi * contact.half_length);
  const double opening_tension = edges.opening / root;
  // The compliance relates the strain at the closing edge to the pressure of the contact.
  const double closing_tension = edges.closing / (creep.after(contact.half_length / speed) * root);
  const auto regular = [&](double tension, double other) {
    if (std::isinf(contact.half_length)) return 0.0;
    const double twice = 2.0 * contact.pressure + 1.25 * tension + 0.5 * other;
    return std::max(twice, 0.0) / (tension * std::sqrt(2.0 * pi)) * (zone / contact.half_length);
  };
  const double time = zone / speed;
  EdgeLaws laws{.opening = {.peak = adhesion.strength, .work = adhesion.separation_work},
                .closing = {.peak = adhesion.strength, .work = adhesion.bonding_work}};
  if (edges.opening_zone <= zone) {
    laws.opening = law_of(opening_edge(creep, time, regular(opening_tension, closing_tension)), edges.opening, zone);
  }
  if (edges.closing_zone <= zone) {
    laws.closing = law_of(closing_edge(creep, time, regular(closing_tension, opening_tension)), edges.closing, zone);
  }
  return laws;
}

}  // namespace viscoroll::detail
