#include "rolling/contact_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace viscoroll::detail {

double estimate_contact_radius(const HarmonicCoating& coating, double load) {
  double shear = std::numeric_limits<double>::infinity();
  double confined = shear;
  for (const Medium<std::complex<double>>& medium : coating.media(0)) {
    shear = std::min(shear, medium.mu.real());
    if (medium.b.real() > 0.0) confined = std::min(confined, medium.mu.real() / medium.b.real());
  }
  const double pi = std::numbers::pi;
  const double radius = coating.outer_radius();
  const double thickness = coating_thickness(coating.sphere());
  const auto load_at = [&](double a) {
    const double hertz = 8.0 / 3.0 * shear * a * a * a / radius;  // nu = 0, the softest
    const double incompressible = pi * shear * std::pow(a, 6) / (32.0 * radius * std::pow(thickness, 3));
    const double compressible = pi * confined * std::pow(a, 4) / (4.0 * radius * thickness);
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
