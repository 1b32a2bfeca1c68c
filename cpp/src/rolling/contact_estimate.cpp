#include "rolling/contact_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "modal/medium.hpp"

namespace viscoroll::detail {
namespace {

/// Of the softest layer.
struct Softness {
  double shear;     ///< modulus [Pa]
  double confined;  ///< modulus of what cannot spread [Pa]
};

/// Layers between two that are rigid, or a half-space.
struct Part {
  double thickness;  ///< [m]
  Softness moduli;
};

/// Moduli of some layers, at a frequency of passing.
Part part_of(std::span<const NamedLayer> layers, double frequency) {
  double thickness = 0.0;
  Softness least{.shear = std::numeric_limits<double>::infinity(), .confined = std::numeric_limits<double>::infinity()};
  for (const auto& [name, layer] : layers) {
    thickness += layer.thickness;
    const auto moduli = complex_modulus(layer.shear_modulus, std::array{0.0, frequency});
    const double shear = std::max(moduli.front().real(), 0.5 * std::abs(moduli.back()));
    const double ratio = shear_ratio(layer, shear);
    least.shear = std::min(least.shear, shear);
    if (ratio > 0.0) least.confined = std::min(least.confined, shear / ratio);
  }
  return {.thickness = thickness, .moduli = least};
}

/// The layers of what rolls, those of what it rolls on, and its base.
std::vector<Part> parts_of(const RollingPair& pair, double frequency) {
  const std::vector<NamedLayer> all = layers(pair);
  const std::size_t own = layers({.body = pair.body, .on = CoatedPlane{}}).size();
  const auto has_end = [](const NamedLayer& named) { return std::isfinite(named.layer.thickness); };
  const std::size_t base = own < all.size() && !has_end(all[own]) ? own + 1 : own;
  std::vector<Part> parts;
  const auto append = [&](std::size_t first, std::size_t last) {
    if (first < last) parts.push_back(part_of(std::span(all).subspan(first, last - first), frequency));
  };
  append(0, own);
  append(own, base);
  append(base, all.size());
  return parts;
}

/// Load of a contact as wide as `a` to either side, by the limits of thick and thin layers.
double load_at(double a, double radius, double thickness, const Softness& moduli, bool roller) {
  const double pi = std::numbers::pi;
  if (roller) {
    const double hertz = 0.5 * pi * moduli.shear * a * a / radius;  // nu = 0, the softest
    const double incompressible = 2.0 * moduli.shear * std::pow(a, 5) / (15.0 * radius * std::pow(thickness, 3));
    const double compressible = 2.0 * moduli.confined * std::pow(a, 3) / (3.0 * radius * thickness);
    return hertz + std::min(incompressible, compressible);
  }
  const double hertz = 8.0 / 3.0 * moduli.shear * a * a * a / radius;  // nu = 0, the softest
  const double incompressible = pi * moduli.shear * std::pow(a, 6) / (32.0 * radius * std::pow(thickness, 3));
  const double compressible = pi * moduli.confined * std::pow(a, 4) / (4.0 * radius * thickness);
  return hertz + std::min(incompressible, compressible);
}

/// Of a circle with the mean of both curvatures.
double mean_radius(const RollingPair& pair) {
  const double radius = outer_radius(pair.body);
  const double across = radius / (1.0 - radius * track_curvature(pair.on).across);
  const double along = relative_radius(pair);
  return across == along ? along : 2.0 / (1.0 / across + 1.0 / along);
}

double contact_radius(const RollingPair& pair, const std::vector<Part>& parts, double load) {
  const double radius = is_roller(pair.body) ? relative_radius(pair) : mean_radius(pair);
  const bool roller = is_roller(pair.body);
  const auto load_of = [&](const Part& part, double a) {
    return load_at(a, radius, part.thickness, part.moduli, roller);
  };
  const auto bears = [&](double a) {
    if (parts.size() == 1) return load_of(parts.front(), a) >= load;
    double compliance = 0.0;  // they add up
    for (const Part& part : parts) compliance += 1.0 / load_of(part, a);
    return compliance * load <= 1.0;
  };
  double low = 0.0;
  double high = radius;
  while (!bears(high)) high *= 2.0;
  // To the last digits: meshes are made to this measure, and results shall be smooth functions of the load.
  while (high - low > 1e-14 * high) {
    const double middle = 0.5 * (low + high);
    (bears(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

double estimate_contact_radius(const RollingPair& pair, double angular_speed, double load) {
  constexpr int kPasses = 3;  // a fixed number of them makes it a smooth function of the load
  double radius = contact_radius(pair, parts_of(pair, 0.0), load);
  for (int pass = 0; pass < kPasses; ++pass) {
    const double frequency = angular_speed * std::max(1.0, outer_radius(pair.body) / radius);
    radius = contact_radius(pair, parts_of(pair, frequency), load);
  }
  return radius;
}

double unbearable_load(const RollingPair& pair, double stiffest_modulus) {
  const double radius = outer_radius(pair.body);
  const double hertz = 16.0 / 3.0 * stiffest_modulus * radius * radius;
  const double bonded =
      std::numbers::pi * stiffest_modulus * std::pow(radius, 5) / (32.0 * std::pow(thickness(pair), 3));
  return 1e3 * (hertz + bonded) / (is_roller(pair.body) ? radius : 1.0);
}

}  // namespace viscoroll::detail
