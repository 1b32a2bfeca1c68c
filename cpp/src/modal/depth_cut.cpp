#include "modal/depth_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "modal/layer_stack.hpp"

namespace viscoroll::detail {

double shear_decay(std::complex<double> mach2) {
  constexpr double kMinDecay = 0.05;  // close to a critical speed the depth would be unbounded
  return std::clamp(std::sqrt(1.0 - mach2).real(), kMinDecay, 1.0);
}

namespace {

/// Decay of an order with depth.
class DepthDecay {
 public:
  /// @param[in] metric metric of the body
  /// @param[in] m,n order along and across
  /// @param[in] least smallest decay rate of all orders, relative to that of an order 1
  DepthDecay(const Metric& metric, double m, double n, double least)
      : metric_(metric),
        around_(std::max(metric.decay_exponent(metric.is_wheel() ? m : std::hypot(m, n)), least)),
        across_(metric.is_wheel() ? n : 0.0) {}

  /// @return e-folds between two positions; on a wheel the integral of sqrt(m^2 + kappa^2) d ln r
  [[nodiscard]] double e_folds(double outer, double inner) const {
    const double folds = around_ * metric_.depth(outer, inner);
    if (across_ == 0.0) return folds;
    const double high = root(outer);
    const double low = root(inner);
    // difference of sqrt(m^2 + kappa^2) - m asinh(m / kappa) between both positions
    return high - low - around_ * std::log((around_ + high) / (around_ + low)) + folds;
  }

  /// @return position that lies `folds` e-folds below another one
  [[nodiscard]] double deeper_position(double position, double folds) const {
    if (across_ == 0.0) return metric_.deeper_position(position, folds / around_);
    // The rate decreases with depth, so that a step with the rate at its start ends above the wanted position.
    double deep = position;
    for (double remaining = folds; remaining > kCloseEnough * folds; remaining = folds - e_folds(position, deep)) {
      deep = metric_.deeper_position(deep, remaining / root(deep));
      if (deep < kCenter * position) return 0.0;
    }
    return deep;
  }

 private:
  static constexpr double kCloseEnough = 1e-3;
  static constexpr double kCenter = 1e-9;  // relative to the starting position; no hub is smaller

  [[nodiscard]] double root(double position) const { return std::hypot(around_, across_ * position / metric_.radius); }

  Metric metric_;
  double around_;  // decay exponent of the order around the center
  double across_;
};

}  // namespace

template <class Scalar>
double deepest_position(const LayerStack<Scalar>& layers, double m, double n, double exponent) {
  // At order 0 a rigid core affects the surface from any depth. Without a core only the uniform expansion does, whose
  // two solutions differ by the third power of the radius.
  const bool has_core = inner_surface(layers.inner_boundary).is_core;
  const DepthDecay decay(layers.metric, m, n, has_core ? 1e-300 : 0.5);
  const double k = std::hypot(m, n);
  const double cosine = k > 0.0 ? m / k : 0.0;
  double remaining = exponent;
  for (auto medium = layers.media.rbegin(); medium != layers.media.rend(); ++medium) {
    const bool is_static = medium->inertia == 0.0;
    const double share = is_static ? 1.0 : shear_decay(layers.mach2(*medium) * (cosine * cosine));
    const double reach = decay.deeper_position(medium->outer, remaining / share);
    if (reach >= medium->inner) return reach;
    remaining -= share * decay.e_folds(medium->outer, medium->inner);
  }
  return -std::numeric_limits<double>::infinity();
}

DepthLimit::DepthLimit(const LayeredBody& body, double angular_speed) : metric_(body.metric) {
  // Below the frequencies of a contact [rad/s], where the layer is softer and the decay slower, which is conservative.
  const std::array passing{10.0 * angular_speed};
  for (const Layer& layer : body.layers) {
    const double modulus = std::abs(complex_modulus(layer.shear_modulus, passing).front());
    decay_ = std::min(decay_, shear_decay(layer.density * std::pow(angular_speed * metric_.radius, 2) / modulus));
  }
}

double DepthLimit::operator()(double position, double exponent) const {
  // On a wheel, orders across decay more slowly than orders along, so that their decay determines the limit.
  const double depth =
      metric_.is_wheel() ? (metric_.radius - position) / metric_.radius : metric_.depth(metric_.surface(), position);
  return depth > 0.0 ? exponent / (depth * decay_) - metric_.decay_exponent(0.0)
                     : std::numeric_limits<double>::infinity();
}

template double deepest_position(const LayerStack<double>&, double, double, double);
template double deepest_position(const LayerStack<std::complex<double>>&, double, double, double);

}  // namespace viscoroll::detail
