#include "rolling/contact_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "modal/medium.hpp"

namespace viscoroll::detail {
namespace {

/// Of the softest layer.
struct Softness {
  double shear;     ///< modulus [Pa]
  double confined;  ///< modulus of what cannot spread [Pa]
};

/// Moduli of what rolls, at a frequency of passing.
Softness softest(const RollingPair& pair, double frequency) {
  Softness least{.shear = std::numeric_limits<double>::infinity(), .confined = std::numeric_limits<double>::infinity()};
  for (const auto& [name, layer] : layers(pair)) {
    const auto moduli = complex_modulus(layer.shear_modulus, std::array{0.0, frequency});
    const double shear = std::max(moduli.front().real(), 0.5 * std::abs(moduli.back()));
    const double ratio = shear_ratio(layer, shear);
    least.shear = std::min(least.shear, shear);
    if (ratio > 0.0) least.confined = std::min(least.confined, shear / ratio);
  }
  return least;
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

double contact_radius(const RollingPair& pair, const Softness& moduli, double load) {
  const double radius = relative_radius(pair);
  const double depth = thickness(pair);
  const bool roller = is_roller(pair.body);
  // Compliances of two bodies add up: half of the stiffness is rather too little.
  const double share = is_rigid(pair.on) || is_rigid(pair.body) ? 1.0 : 2.0;
  const auto bears = [&](double a) { return load_at(a, radius, depth, moduli, roller) >= share * load; };
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
  double radius = contact_radius(pair, softest(pair, 0.0), load);
  for (int pass = 0; pass < kPasses; ++pass) {
    const double frequency = angular_speed * std::max(1.0, outer_radius(pair.body) / radius);
    radius = contact_radius(pair, softest(pair, frequency), load);
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
