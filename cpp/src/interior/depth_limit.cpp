#include "interior/depth_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace viscoroll::detail {

DepthLimit::DepthLimit(const CoatedSphere& sphere, double angular_speed) : radius_(outer_radius(sphere)), decay_(1.0) {
  constexpr double kLeastDecay = 0.05;
  const std::array passing{10.0 * angular_speed};  // slower than what passes a contact: softer, and so on the safe side
  for (const Layer& layer : sphere.layers) {
    const double modulus = std::abs(complex_modulus(layer.shear_modulus, passing).front());
    const double mach2 = layer.density * std::pow(angular_speed * radius_, 2) / modulus;
    decay_ = std::min(decay_, std::sqrt(std::max(1.0 - mach2, kLeastDecay * kLeastDecay)));
  }
}

double DepthLimit::operator()(const Place& place, double exponent) const {
  const double depth = std::log(radius_ / place.radius);
  return depth > 0.0 ? exponent / (depth * decay_) : std::numeric_limits<double>::infinity();
}

}  // namespace viscoroll::detail
