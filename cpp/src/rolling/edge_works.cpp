#include "rolling/edge_works.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <string>

#include "base/validate.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll::detail {
namespace {

using std::numbers::pi;

/// A cubic law acts on a viscoelastic edge as Dugdale's law with this fraction of its peak. Of 0.70, 0.72, 0.75 and
/// 0.80, this value is the best for rollers on a half-plane with moduli of 2:1 and 10:1 (docs/theory/adhesion.md,
/// "Evidence").
constexpr double kDugdaleFraction = 0.75;

/// Means of the creep compliance over a cohesive zone.
struct ZoneMeans {
  double opening;    ///< weighted by the slope of the opening edge's gap [1/Pa]
  double intensity;  ///< weighted by s^(-1/2) over the closing edge [1/Pa]

  /// Weight of the gap at the end of the closing zone.
  [[nodiscard]] double closing() const { return 2.0 * intensity - opening; }
};

/// Nodes of the trapezoidal rule in y for integrals over a zone, with eta = tanh(y)^2.
struct ZoneNode {
  double rest;       ///< 1 - eta
  double opening;    ///< spacing times deta/dy ln((1 + sqrt(eta)) / (1 - sqrt(eta))) / 2
  double intensity;  ///< spacing times deta/dy / (2 sqrt(eta))
};

constexpr double kZoneSpacing = 0.125;

const std::vector<ZoneNode>& zone_nodes() {
  static const std::vector<ZoneNode> kNodes = [] {
    constexpr int kCount = 1600;  // for x up to 1e150
    std::vector<ZoneNode> nodes;
    nodes.reserve(kCount);
    for (int i = 0; i < kCount; ++i) {
      const double y = kZoneSpacing * i;
      const double rest = std::pow(std::cosh(y), -2.0);
      const double weight = (i == 0 ? 0.5 : 1.0) * kZoneSpacing * rest;
      nodes.push_back({.rest = rest, .opening = weight * 2.0 * y * std::tanh(y), .intensity = weight});
    }
    return nodes;
  }();
  return kNodes;
}

/// Means of exp(-(1 - eta) x) over 0 < eta < 1 with the weights ln((1 + sqrt(eta)) / (1 - sqrt(eta))) / 2 and
/// 1 / (2 sqrt(eta)). The integrands in y are even and analytic for |Im y| < pi / 4, so that the error of the
/// trapezoidal rule is exp(-pi^2 / (2 h)) for the spacing h.
std::array<double, 2> decay_means(double x) {
  constexpr double kLargest = 1e150;  // the means are below log(x) / x
  constexpr double kUnderflow = 745.0;
  constexpr double kEnd = 20.0;  // exp(-2 kEnd) < 1e-17
  if (x > kLargest) return {0.0, 0.0};
  const std::vector<ZoneNode>& nodes = zone_nodes();
  const double end = (0.5 * std::log1p(4.0 * x) + kEnd) / kZoneSpacing;
  const auto first = std::ranges::find_if(nodes, [x](const ZoneNode& node) { return x * node.rest < kUnderflow; });
  double opening = 0.0;
  double intensity = 0.0;
  for (auto node = first; node < nodes.begin() + static_cast<std::ptrdiff_t>(end); ++node) {
    const double decay = std::exp(-x * node->rest);
    opening += decay * node->opening;
    intensity += decay * node->intensity;
  }
  return {opening, intensity};
}

/// @param[in] time time in which material passes the zone [s]
ZoneMeans zone_means(const EdgeCreep& creep, double time) {
  const double relaxed = creep.relaxed();
  ZoneMeans means{.opening = relaxed, .intensity = relaxed};
  for (std::size_t j = 0; j < creep.delayed.size(); ++j) {
    const auto [opening, intensity] = decay_means(time / creep.retardation_times[j]);
    means.opening -= creep.delayed[j] * opening;
    means.intensity -= creep.delayed[j] * intensity;
  }
  return means;
}

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

/// Fracture mechanics of an edge with a cohesive zone of Dugdale's shape. Stress intensities are K at the opening edge,
/// and its counterpart K_c at the closing edge.
struct DugdaleZone {
  DugdaleZone(const EdgeCreep& creep, double zone_length, double speed)
      : length(zone_length), means(zone_means(creep, zone_length / speed)) {}

  double length;
  ZoneMeans means;

  /// Half of the squared stress intensity of an elastic zone with the peak of a cubic law [Pa^2 m].
  [[nodiscard]] double half_square(double peak) const {
    return 4.0 / pi * std::pow(kDugdaleFraction * peak, 2) * length;
  }

  [[nodiscard]] double opening_work(double peak) const { return half_square(peak) * means.opening; }
  [[nodiscard]] double closing_work(double peak) const { return half_square(peak) * means.closing(); }
  /// K_c^2 [m]
  [[nodiscard]] double closing_intensity(double peak) const {
    return 2.0 * half_square(peak) * std::pow(means.intensity, 2);
  }

  /// Law with a K^2 [Pa^2 m].
  [[nodiscard]] EdgeLaw opening_law(double intensity) const {
    const double peak = std::sqrt(0.5 * intensity / half_square(1.0));
    return {.peak = peak, .work = opening_work(peak)};
  }
  /// Law with a K_c^2 [m].
  [[nodiscard]] EdgeLaw closing_law(double intensity) const {
    const double peak = std::sqrt(intensity / closing_intensity(1.0));
    return {.peak = peak, .work = closing_work(peak)};
  }
};

/// Length of a zone under a finite strength with the elastic energy release rate `work` by the relaxed compliance.
double elastic_length(const EdgeCreep& creep, double work, double strength) {
  return 0.25 * pi * work / (creep.relaxed() * std::pow(kDugdaleFraction * strength, 2));
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
  if (creep.instantaneous <= 0.0) {
    reject(kParameter,
           "finite for a material without instantaneous compliance; give the strength [Pa] or the range [m]", "inf");
  }
  if (creep.retardation_times.empty()) return;
  const auto [shortest, longest] = std::ranges::minmax(creep.retardation_times);
  if (longest > kWidestSpectrum * shortest) {
    reject(kParameter,
           "finite for a material with retardation times from " + rounded(shortest) + " to " + rounded(longest) +
               " s, because the work of separation depends on the strength; give the strength [Pa] or the range [m]",
           "inf");
  }
}

}  // namespace

double EdgeCreep::relaxed() const { return std::accumulate(delayed.begin(), delayed.end(), instantaneous); }

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

EdgeWorks edge_works(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double zone, double speed) {
  const auto& [separation, bonding, strength] = adhesion;
  const auto zone_at = [&](double length) { return DugdaleZone(creep, length, speed); };
  double opening_length = 0.0;
  double closing_length = 0.0;
  double opening_intensity = 0.0;
  double closing_intensity = 0.0;
  if (std::isinf(strength)) {
    require_strength(creep);
    const double compliance = speed == 0.0 ? creep.relaxed() : creep.instantaneous;
    opening_intensity = 2.0 * separation / compliance;
    closing_intensity = 2.0 * bonding * compliance;
  } else {
    opening_length = length_at(separation, elastic_length(creep, separation, strength),
                               [&](double length) { return zone_at(length).opening_work(strength); });
    closing_length = length_at(bonding, elastic_length(creep, bonding, strength),
                               [&](double length) { return zone_at(length).closing_work(strength); });
    opening_intensity = 2.0 * zone_at(opening_length).half_square(strength);
    closing_intensity = zone_at(closing_length).closing_intensity(strength);
  }
  const DugdaleZone mesh = zone_at(zone);
  return {
      .laws = {.opening = opening_length > zone ? EdgeLaw{strength, separation} : mesh.opening_law(opening_intensity),
               .closing = closing_length > zone ? EdgeLaw{strength, bonding} : mesh.closing_law(closing_intensity)},
      .opening_release = 0.5 * opening_intensity * creep.relaxed(),
      .closing_release = 0.5 * closing_intensity / creep.relaxed(),
      .actual_opening_zone = opening_length,
      .actual_closing_zone = closing_length};
}

}  // namespace viscoroll::detail
