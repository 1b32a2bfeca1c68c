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
  std::vector<Part> parts;
  const auto append = [&](std::span<const NamedLayer> layers) {
    if (!layers.empty()) parts.push_back(part_of(layers, frequency));
  };
  append(pair.body.layers);
  const std::span<const NamedLayer> counterpart = pair.on.layers;
  const std::size_t base = !counterpart.empty() && std::isinf(counterpart.front().layer.thickness) ? 1 : 0;
  append(counterpart.first(base));
  append(counterpart.subspan(base));
  return parts;
}

/// Load of a contact as wide as `a` to either side, by the limits of thick and thin layers.
double load_at(double a, double radius, const Part& part, const ContactForm& form) {
  const auto& [thickness, moduli] = part;
  const double strip = std::pow(a, form.dimensions) / radius;
  const double hertz = form.thick * moduli.shear * strip * a;  // nu = 0, the softest
  const double incompressible = form.incompressible * moduli.shear * strip * std::pow(a, 4) / std::pow(thickness, 3);
  const double compressible = form.confined * moduli.confined * strip * a * a / thickness;
  return hertz + std::min(incompressible, compressible);
}

/// Of a circle, or a line, with the mean of the curvatures.
double mean_radius(const RollingPair& pair) {
  const Curvatures& own = pair.body.curvatures;
  const Curvatures& counterpart = pair.on.curvatures;
  return pair.body.form.dimensions / (own.along + counterpart.along + own.across + counterpart.across);
}

double contact_radius(const RollingPair& pair, const std::vector<Part>& parts, double load) {
  const double radius = mean_radius(pair);
  const auto load_of = [&](const Part& part, double a) { return load_at(a, radius, part, pair.body.form); };
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
    const double frequency = angular_speed * std::max(1.0, pair.body.radius / radius);
    radius = contact_radius(pair, parts_of(pair, frequency), load);
  }
  return radius;
}

double unbearable_load(const RollingPair& pair, double stiffest_modulus) {
  const double radius = pair.body.radius;
  const double hertz = 16.0 / 3.0 * stiffest_modulus * radius * radius;
  const double bonded =
      std::numbers::pi * stiffest_modulus * std::pow(radius, 5) / (32.0 * std::pow(thickness(pair), 3));
  return 1e3 * (hertz + bonded) / std::pow(radius, 2 - pair.body.form.dimensions);
}

}  // namespace viscoroll::detail
