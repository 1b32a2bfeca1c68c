#include "rolling/contact_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace viscoroll::detail {
namespace {

/// Of the softest layer.
struct Softness {
  double shear;     ///< modulus [Pa]
  double confined;  ///< modulus of what cannot spread [Pa]
};

/// Moduli of what rolls, at a frequency of passing.
Softness softest(const CoatedSphere& sphere, double frequency) {
  Softness least{.shear = std::numeric_limits<double>::infinity(), .confined = std::numeric_limits<double>::infinity()};
  for (const Layer& layer : sphere.layers) {
    const auto moduli = complex_modulus(layer.shear_modulus, std::array{0.0, frequency});
    const double shear = std::max(moduli.front().real(), 0.5 * std::abs(moduli.back()));
    const double ratio = shear_ratio(layer, shear);
    least.shear = std::min(least.shear, shear);
    if (ratio > 0.0) least.confined = std::min(least.confined, shear / ratio);
  }
  return least;
}

double contact_radius(const CoatedSphere& sphere, const Softness& moduli, double load) {
  const double pi = std::numbers::pi;
  const double radius = outer_radius(sphere);
  const double thickness = coating_thickness(sphere);
  const auto load_at = [&](double a) {
    const double hertz = 8.0 / 3.0 * moduli.shear * a * a * a / radius;  // nu = 0, the softest
    const double incompressible = pi * moduli.shear * std::pow(a, 6) / (32.0 * radius * std::pow(thickness, 3));
    const double compressible = pi * moduli.confined * std::pow(a, 4) / (4.0 * radius * thickness);
    return hertz + std::min(incompressible, compressible);
  };
  double low = 0.0;
  double high = radius;
  while (load_at(high) < load) high *= 2.0;
  // To the last digits: meshes are made to this measure, and results shall be smooth functions of the load.
  while (high - low > 1e-14 * high) {
    const double middle = 0.5 * (low + high);
    (load_at(middle) < load ? low : high) = middle;
  }
  return high;
}

}  // namespace

double estimate_contact_radius(const CoatedSphere& sphere, double angular_speed, double load) {
  constexpr int kPasses = 3;  // a fixed number of them makes it a smooth function of the load
  double radius = contact_radius(sphere, softest(sphere, 0.0), load);
  for (int pass = 0; pass < kPasses; ++pass) {
    const double frequency = angular_speed * std::max(1.0, outer_radius(sphere) / radius);
    radius = contact_radius(sphere, softest(sphere, frequency), load);
  }
  return radius;
}

double unbearable_load(const HarmonicCoating& coating) {
  double shear = 0.0;
  const auto highest = std::max_element(coating.orders().begin(), coating.orders().end()) - coating.orders().begin();
  for (const Medium<std::complex<double>>& medium : coating.media(static_cast<std::size_t>(highest))) {
    shear = std::max(shear, std::abs(medium.mu));
  }
  const double radius = coating.outer_radius();
  const double thickness = coating_thickness(coating.sphere());
  const double hertz = 16.0 / 3.0 * shear * radius * radius;
  const double bonded = std::numbers::pi * shear * std::pow(radius, 5) / (32.0 * std::pow(thickness, 3));
  return 1e3 * (hertz + bonded);
}

}  // namespace viscoroll::detail
