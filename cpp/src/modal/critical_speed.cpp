// Critical speed, above which rolling radiates waves: docs/theory/inertia.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/invalid_speed.hpp"
#include "base/validate.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Layers with their short-time moduli at unit speed. A layer without a finite short-time modulus is rigid; together
/// with all layers below it, it becomes the core or base.
LayerStack<double> short_time_stack(const LayeredBody& body, double highest_frequency) {
  std::vector<double> moduli;
  moduli.reserve(body.layers.size());
  for (const Layer& layer : body.layers) moduli.push_back(short_time_modulus(layer.shear_modulus, highest_frequency));
  LayerStack<double> stack = body.stack(moduli, 1.0);
  const auto rigid = std::ranges::find_if(moduli.rbegin(), moduli.rend(), [](double mu) { return std::isinf(mu); });
  if (rigid == moduli.rend()) return stack;
  stack.media.erase(stack.media.begin(), stack.media.begin() + (moduli.rend() - rigid));
  stack.inner_boundary = InnerBoundary::rigid;
  return stack;
}

LayerStack<double> at_speed(LayerStack<double> stack, double angular_speed) {
  for (Medium<double>& medium : stack.media) medium.inertia *= angular_speed * angular_speed;
  return stack;
}

/// Speed at which the surface reaches the shear wave speed of a layer; infinite without inertia.
double shear_wave(const LayerStack<double>& stack, const Medium<double>& medium) {
  return medium.inertia > 0.0 ? std::sqrt(medium.mu / medium.inertia) / stack.metric.radius : kInfinity;
}

/// Ratio of the Rayleigh wave speed to the shear wave speed; 0.955 for an incompressible material.
/// @param[in] shear_ratio b = mu / (lambda + 2 mu), in [0, 3/4)
double rayleigh_ratio(double shear_ratio) {
  // x^3 - 8 x^2 + (24 - 16 b) x - 16 (1 - b) = 0 with x = (c / c_s)^2 and b = (c_s / c_p)^2; its smallest positive root
  // lies in (0, 1). K. F. Graff, Wave Motion in Elastic Solids (1975), equation (6.1.85).
  const double b = shear_ratio;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    const double value = ((x - 8.0) * x + 24.0 - 16.0 * b) * x - 16.0 * (1.0 - b);
    (value < 0.0 ? low : high) = x;
  }
  return std::sqrt(0.5 * (low + high));
}

double rayleigh_wave(const LayerStack<double>& stack, const Medium<double>& medium) {
  return rayleigh_ratio(medium.b) * shear_wave(stack, medium);
}

/// Lowest shear wave speed of all layers.
double slowest_shear_wave(const LayerStack<double>& stack) {
  double speed = kInfinity;
  for (const Medium<double>& medium : stack.media) speed = std::min(speed, shear_wave(stack, medium));
  return speed;
}

/// Upper bound of surface wave speeds: the Rayleigh speed of the outer layer, which short waves have, or of a
/// half-space, which long waves have.
double rayleigh_limit(const LayerStack<double>& stack) {
  const double outer = rayleigh_wave(stack, stack.media.back());
  return stack.media.front().is_half_space() ? std::min(outer, rayleigh_wave(stack, stack.media.front())) : outer;
}

/// Upper bound of the critical speed. On a plane, waves of any length can escape into a layer with a lower shear wave
/// speed; around a center only integer orders resonate.
double speed_limit(const LayerStack<double>& stack) {
  const double rayleigh = rayleigh_limit(stack);
  return stack.metric.is_curved() ? rayleigh : std::min(rayleigh, slowest_shear_wave(stack));
}

/// Orders m that are checked, spaced geometrically because resonances depend smoothly on the order. Around a center
/// they are whole numbers; on a plane the waves reach from far longer than the thickness of the layers to far shorter.
std::vector<double> orders_to_check(const LayerStack<double>& stack) {
  std::vector<double> orders;
  if (stack.metric.is_curved()) {
    constexpr int kHighestOrder = 2000;
    for (int m = 1; m <= kHighestOrder; m = std::max(m + 1, m * 11 / 10)) orders.push_back(m);
    return orders;
  }
  double thinnest = kInfinity;
  double thickness = 0.0;
  for (const Medium<double>& medium : stack.media) {
    if (medium.is_half_space()) continue;
    thinnest = std::min(thinnest, medium.outer - medium.inner);
    thickness += medium.outer - medium.inner;
  }
  const double radius = stack.metric.radius;
  if (thickness == 0.0) return {radius};
  for (double k = 1e-3 / thickness; k < 50.0 / thinnest; k *= 1.1) orders.push_back(k * radius);
  return orders;
}

/// Whether the stiffness of orders is positive. The slowest waves travel along the path, so n = 0. On a wheel, whose
/// compliance is not a function of m^2 + n^2, oblique waves are also checked.
bool are_stiff(const LayerStack<double>& stack, const std::vector<double>& orders) {
  constexpr std::array kObliquities{0.0, 0.25, 0.5, 1.0, 2.0};  // n / m
  std::vector<OrderInLayers<double>> in_layers;
  for (const double m : orders) {
    for (const double share : std::span(kObliquities).first(stack.metric.is_wheel() ? kObliquities.size() : 1)) {
      in_layers.push_back({.layers = stack, .m = m, .n = share * m});
    }
  }
  return are_subcritical(in_layers);
}

/// Whether no order resonates at or below this speed.
bool all_subcritical(const LayerStack<double>& stack, double angular_speed) {
  return angular_speed < speed_limit(stack) && are_stiff(at_speed(stack, angular_speed), orders_to_check(stack));
}

/// Lowest speed at which a wave of undamped layers keeps up with the contact: Omega [rad/s], for a plane the speed
/// divided by the radius of its metric; infinite without inertia.
/// @param[in] stack layers with their short-time moduli at unit speed
double critical_speed(const LayerStack<double>& stack) {
  if (stack.media.empty()) return kInfinity;
  const double limit = speed_limit(stack);
  // An outer layer without density gives no finite limit. Far above all shear wave speeds no further order resonates.
  double high = std::min(limit, 100.0 * slowest_shear_wave(stack));
  if (std::isinf(high) || all_subcritical(stack, high * (1.0 - 1e-12))) return limit;
  double low = 0.0;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (all_subcritical(stack, middle) ? low : high) = middle;
  }
  return low;
}

double critical_speed(const LayeredBody& body, double highest_frequency) {
  return critical_speed(short_time_stack(body, highest_frequency));
}

}  // namespace

void require_subcritical(const LayeredBody& body, double angular_speed, double highest_frequency) {
  const LayerStack<double> stack = short_time_stack(body, highest_frequency);
  if (stack.media.empty() || angular_speed < 0.1 * slowest_shear_wave(stack)) return;
  if (all_subcritical(stack, angular_speed)) return;
  const double critical = critical_speed(stack);
  const std::string radiating =
      body.metric.is_curved() ? "coating of radius " + rounded(body.metric.radius) + " m" : "plane";
  throw InvalidSpeed(angular_speed, {.before = "below the critical speed ",
                                     .bound = SpeedRule::Bound::excluded_maximum,
                                     .limit = critical,
                                     .after = ", above which the " + radiating + " radiates waves"});
}

void require_damped_waves(const HarmonicBody& body) {
  if (!body.metric().is_curved()) return;  // waves do not return on a plane
  double next = 1.0;
  for (std::size_t i = 0; i < body.orders().size(); ++i) {
    const double m = body.orders()[i];
    if (m < next) continue;
    next = std::max(m + 1.0, 1.1 * m);
    std::vector<double> moduli;
    double damping = 0.0;  // largest m tan(delta) of the layers
    for (std::size_t j = 0; j < body.body().layers.size(); ++j) {
      const std::complex<double> modulus = body.modulus(j, i);
      moduli.push_back(modulus.real());
      damping = std::max(damping, m * modulus.imag() / modulus.real());
    }
    const LayerStack<double> stack = body.body().stack(moduli, body.angular_speed());
    const double slowest = slowest_shear_wave(stack);  // relative to the rolling speed, which the inertia contains
    if (damping > 1.0 || slowest > 10.0 || are_stiff(stack, {m})) continue;
    throw InvalidSpeed(body.angular_speed(),
                       {.before = "below the speed at which the coating radiates waves of order " + text(m) +
                                  ", which its material hardly damps"});
  }
}

}  // namespace detail

double critical_speed(const CoatedSphere& sphere, double highest_frequency, Curvature curvature) {
  return detail::critical_speed(detail::checked_layered_body(sphere, curvature), highest_frequency);
}

double critical_speed(const CoatedCylinder& cylinder, double highest_frequency) {
  return detail::critical_speed(detail::checked_layered_body(cylinder), highest_frequency);
}

double critical_speed(const CoatedWheel& wheel, double highest_frequency) {
  return detail::critical_speed(detail::checked_layered_body(wheel), highest_frequency);
}

double critical_speed(const CoatedPlane& plane, double highest_frequency) {
  return detail::critical_speed(detail::checked_layered_body(plane, 1.0), highest_frequency);
}

}  // namespace viscoroll
