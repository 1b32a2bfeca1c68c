#include "modal/depth_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "modal/inner_boundary.hpp"

namespace viscoroll::detail {

double shear_decay(std::complex<double> mach2) {
  constexpr double kLeast = 0.05;  // next to a critical speed the depth would be without end
  return std::clamp(std::sqrt(1.0 - mach2).real(), kLeast, 1.0);
}

template <class Scalar>
double deepest_place(const LayerStack<Scalar>& layers, double m, double k, double exponent) {
  // At order 0 what a rigid core holds reaches the surface from any depth; without one, only the uniform swelling does,
  // whose two solutions differ by the third power of the radius.
  const bool held = inner_surface(layers.within).is_core;
  const double fall = std::max(layers.metric.fall(k), held ? 1e-300 : 0.5);
  const double cosine = k > 0.0 ? m / k : 0.0;
  double left = exponent;
  for (auto medium = layers.media.rbegin(); medium != layers.media.rend(); ++medium) {
    const bool still = medium->inertia == 0.0;
    const double rate = fall * (still ? 1.0 : shear_decay(layers.mach2(*medium) * (cosine * cosine)));
    const double reach = layers.metric.below(medium->outer, left / rate);
    if (reach >= medium->inner) return reach;
    left -= rate * layers.metric.depth(medium->outer, medium->inner);
  }
  return -std::numeric_limits<double>::infinity();
}

DepthLimit::DepthLimit(const LayeredBody& body, double angular_speed) : metric_(body.metric) {
  const std::array passing{10.0 * angular_speed};  // slower than what passes a contact: softer, and so on the safe side
  for (const Layer& layer : body.layers) {
    const double modulus = std::abs(complex_modulus(layer.shear_modulus, passing).front());
    decay_ = std::min(decay_, shear_decay(layer.density * std::pow(angular_speed * metric_.radius, 2) / modulus));
  }
}

double DepthLimit::operator()(double place, double exponent) const {
  const double depth = metric_.depth(metric_.surface(), place);
  return depth > 0.0 ? exponent / (depth * decay_) - metric_.fall(0.0) : std::numeric_limits<double>::infinity();
}

template double deepest_place(const LayerStack<double>&, double, double, double);
template double deepest_place(const LayerStack<std::complex<double>>&, double, double, double);

}  // namespace viscoroll::detail
