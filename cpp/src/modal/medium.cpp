#include "modal/medium.hpp"

#include <algorithm>
#include <numeric>

#include "modal/critical_speed.hpp"
#include "validate.hpp"

namespace viscoroll::detail {

HarmonicCoating::HarmonicCoating(const CoatedSphere& sphere, double angular_speed, std::span<const int> harmonics)
    : sphere_(sphere), angular_speed_(angular_speed) {
  validate(sphere);
  require_positive("angular_speed", angular_speed, "rad/s");

  std::vector<double> omega;
  omega.reserve(harmonics.size());
  for (const int m : harmonics) omega.push_back(m * angular_speed);

  radii_.push_back(sphere.core_radius);
  for (const Layer& layer : sphere.layers) {
    radii_.push_back(radii_.back() + layer.thickness);
    moduli_.push_back(complex_modulus(layer.shear_modulus, omega));
  }
  const double highest = omega.empty() ? 0.0 : *std::max_element(omega.begin(), omega.end());
  require_subcritical(sphere, angular_speed, std::max(highest, angular_speed));
  require_damped_waves(sphere, angular_speed, harmonics, moduli_);
}

std::vector<Medium<std::complex<double>>> HarmonicCoating::media(std::size_t i) const {
  std::vector<Medium<std::complex<double>>> media;
  media.reserve(sphere_.layers.size());
  for (std::size_t j = 0; j < sphere_.layers.size(); ++j) {
    const Layer& layer = sphere_.layers[j];
    const std::complex<double> mu = modulus(j, i);
    media.push_back({.inner_radius = radii_[j],
                     .outer_radius = radii_[j + 1],
                     .mu = mu,
                     .b = shear_ratio(layer, mu),
                     .inertia = layer.density * angular_speed_ * angular_speed_});
  }
  media.front().within = sphere_.inner_boundary;
  return media;
}

std::vector<int> orders_up_to(int max_order) {
  std::vector<int> orders(static_cast<std::size_t>(max_order) + 1);
  std::iota(orders.begin(), orders.end(), 0);
  return orders;
}

}  // namespace viscoroll::detail
