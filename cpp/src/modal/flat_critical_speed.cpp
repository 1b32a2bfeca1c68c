#include "modal/flat_critical_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "modal/critical_speed.hpp"
#include "modal/flat_layers.hpp"
#include "modal/harmonic_plane.hpp"
#include "modal/medium.hpp"
#include "validate.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The layers at infinite frequency and unit speed. A layer without a finite short-time modulus is rigid there: it is
/// the base of those above.
std::vector<FlatMedium<double>> short_time_media(const CoatedPlane& plane, double highest_frequency) {
  std::vector<FlatMedium<double>> media;
  for (const Layer& layer : layers_from_base(plane)) {
    const double mu = short_time_modulus(layer.shear_modulus, highest_frequency);
    if (std::isinf(mu)) {
      media.clear();
    } else {
      media.push_back({.thickness = layer.thickness, .mu = mu, .b = shear_ratio(layer, mu), .inertia = layer.density});
    }
  }
  return media;
}

/// Speed of the Rayleigh waves of a half-space.
double rayleigh_speed(const FlatMedium<double>& medium) {
  return medium.inertia > 0.0 ? rayleigh_ratio(medium.b) * std::sqrt(medium.mu / medium.inertia) : kInfinity;
}

/// The slowest wave of any material; infinite without inertia.
double slowest_shear_wave(const std::vector<FlatMedium<double>>& media) {
  double speed = kInfinity;
  for (const FlatMedium<double>& medium : media) {
    if (medium.inertia > 0.0) speed = std::min(speed, std::sqrt(medium.mu / medium.inertia));
  }
  return speed;
}

/// What bounds the speeds of surface waves: that of the outer layer's, of short waves, and the base's, of long ones.
double rayleigh_limit(const std::vector<FlatMedium<double>>& media) {
  const double outer = rayleigh_speed(media.back());
  return std::isinf(media.front().thickness) ? std::min(outer, rayleigh_speed(media.front())) : outer;
}

/// Whether no wave resonates: the slowest ones run straight along the way.
bool all_subcritical(std::vector<FlatMedium<double>> media, double speed) {
  double thinnest = kInfinity;
  double thickness = 0.0;
  for (FlatMedium<double>& medium : media) {
    medium.inertia *= speed * speed;
    if (std::isinf(medium.thickness)) continue;
    thinnest = std::min(thinnest, medium.thickness);
    thickness += medium.thickness;
  }
  if (thickness == 0.0) return is_subcritical(media, 1.0);
  for (double k = 1e-3 / thickness; k < 50.0 / thinnest; k *= 1.1) {
    if (!is_subcritical(media, k)) return false;
  }
  return true;
}

double critical_speed_of(const std::vector<FlatMedium<double>>& media) {
  if (media.empty()) return kInfinity;
  const double highest = std::min(rayleigh_limit(media), slowest_shear_wave(media));
  if (std::isinf(highest) || all_subcritical(media, highest * (1.0 - 1e-12))) return highest;
  double low = 0.0;
  double high = highest;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (all_subcritical(media, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

void require_subcritical(const CoatedPlane& plane, double speed, double highest_frequency) {
  const std::vector<FlatMedium<double>> media = short_time_media(plane, highest_frequency);
  if (media.empty() || speed < 0.1 * slowest_shear_wave(media)) return;
  if (speed < rayleigh_limit(media) && all_subcritical(media, speed)) return;
  reject("angular_speed",
         "such that the plane's material passes at less than the critical speed " + text(critical_speed_of(media)) +
             " m/s, above which the plane radiates waves",
         text(speed) + " m/s");
}

}  // namespace detail

double critical_speed(const CoatedPlane& plane, double highest_frequency) {
  validate(plane);
  return detail::critical_speed_of(detail::short_time_media(plane, highest_frequency));
}

}  // namespace viscoroll
