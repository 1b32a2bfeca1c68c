#include "modal/critical_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "modal/compliance_recursion.hpp"
#include "modal/cylinder_compliance.hpp"
#include "modal/medium.hpp"
#include "validate.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The layers at infinite frequency and unit rolling speed. A layer without a finite short-time modulus is rigid there:
/// it and all below it become the core.
std::vector<Medium<double>> short_time_media(const CoatedSphere& sphere, double highest_frequency,
                                             Curvature curvature = Curvature::sphere) {
  std::vector<Medium<double>> media;
  double radius = sphere.core_radius;
  for (const Layer& layer : sphere.layers) {
    const double inner = radius;
    radius += layer.thickness;
    const double mu = short_time_modulus(layer.shear_modulus, highest_frequency);
    if (std::isinf(mu)) {
      media.clear();
      continue;
    }
    media.push_back({.inner_radius = inner,
                     .outer_radius = radius,
                     .mu = mu,
                     .b = shear_ratio(layer, mu),
                     .inertia = layer.density,
                     .within = inner == sphere.core_radius ? sphere.inner_boundary : InnerBoundary::rigid,
                     .curvature = curvature});
  }
  return media;
}

/// Speed of the surface's Rayleigh wave, the limit of large orders; infinite without inertia.
double rayleigh_limit(const std::vector<Medium<double>>& media) {
  const Medium<double>& outer = media.back();
  if (outer.inertia == 0.0) return kInfinity;
  return rayleigh_ratio(outer.b) * std::sqrt(outer.mu / outer.inertia) / outer.outer_radius;
}

/// Whether the stiffness of orders m, with n = 0 where there is an n, stays positive on a geometry.
using StiffnessCheck = bool (*)(std::span<const Medium<double>> media, std::span<const double> orders);

bool are_stiff_on_sphere(std::span<const Medium<double>> media, std::span<const double> orders) {
  std::vector<OrderInLayers<double>> in_layers;
  for (const double m : orders) in_layers.push_back({.media = media, .m = m, .n = 0.0});
  return are_subcritical(in_layers);
}

bool are_stiff_on_cylinder(std::span<const Medium<double>> media, std::span<const double> orders) {
  return std::ranges::all_of(orders, [&](double m) { return is_subcritical(media, m); });
}

/// Whether no order resonates up to this speed. The slowest waves run straight along phi, so n = 0; the orders are
/// spaced geometrically, since the resonances depend smoothly on the order.
bool all_subcritical(std::vector<Medium<double>> media, double angular_speed, StiffnessCheck are_stiff) {
  constexpr int kHighestOrder = 2000;
  for (Medium<double>& medium : media) medium.inertia *= angular_speed * angular_speed;
  std::vector<double> orders;
  for (int m = 1; m <= kHighestOrder; m = std::max(m + 1, m * 11 / 10)) orders.push_back(m);
  return are_stiff(media, orders);
}

/// Rolling speed at which the surface keeps up with the slowest shear wave of any layer; infinite without inertia.
double slowest_shear_wave(const std::vector<Medium<double>>& media) {
  double speed = kInfinity;
  for (const Medium<double>& medium : media) {
    if (medium.inertia > 0.0)
      speed = std::min(speed, std::sqrt(medium.mu / medium.inertia) / media.back().outer_radius);
  }
  return speed;
}

double critical_speed(const std::vector<Medium<double>>& media, StiffnessCheck are_stiff) {
  if (media.empty()) return kInfinity;
  const double rayleigh = rayleigh_limit(media);
  // An outer layer without mass sets no limit of its own; far above every shear wave nothing new can resonate.
  double high = std::min(rayleigh, 100.0 * slowest_shear_wave(media));
  if (std::isinf(high)) return high;
  if (all_subcritical(media, high, are_stiff)) return rayleigh;
  double low = 0.0;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (all_subcritical(media, middle, are_stiff) ? low : high) = middle;
  }
  return low;
}

void require_subcritical(const std::vector<Medium<double>>& media, double angular_speed, StiffnessCheck are_stiff) {
  if (media.empty() || angular_speed < 0.1 * slowest_shear_wave(media)) return;
  if (angular_speed < rayleigh_limit(media) && all_subcritical(media, angular_speed, are_stiff)) return;
  reject("angular_speed",
         "below the critical speed " + text(critical_speed(media, are_stiff)) +
             " rad/s, above which the coating radiates waves",
         text(angular_speed) + " rad/s");
}

}  // namespace

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

void require_subcritical(const CoatedSphere& sphere, double angular_speed, double highest_frequency,
                         Curvature curvature) {
  require_subcritical(short_time_media(sphere, highest_frequency, curvature), angular_speed, are_stiff_on_sphere);
}

void require_subcritical(const CoatedCylinder& cylinder, double angular_speed, double highest_frequency) {
  require_subcritical(short_time_media(layers_about_center(cylinder), highest_frequency), angular_speed,
                      are_stiff_on_cylinder);
}

namespace {

void require_damped_waves(const CoatedSphere& sphere, double angular_speed, std::span<const double> orders,
                          const std::vector<std::vector<std::complex<double>>>& moduli, Curvature curvature,
                          StiffnessCheck are_stiff) {
  double next = 1.0;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const double m = orders[i];
    if (m < next) continue;
    next = std::max(m + 1.0, 1.1 * m);
    std::vector<Medium<double>> media;
    double radius = sphere.core_radius;
    double damping = 0.0;  // the largest m tan(delta)
    for (std::size_t j = 0; j < sphere.layers.size(); ++j) {
      const Layer& layer = sphere.layers[j];
      const double mu = moduli[j][i].real();
      damping = std::max(damping, m * moduli[j][i].imag() / mu);
      media.push_back({.inner_radius = radius,
                       .outer_radius = radius + layer.thickness,
                       .mu = mu,
                       .b = shear_ratio(layer, mu),
                       .inertia = layer.density * angular_speed * angular_speed,
                       .within = j == 0 ? sphere.inner_boundary : InnerBoundary::rigid,
                       .curvature = curvature});
      radius += layer.thickness;
    }
    const double slowest = slowest_shear_wave(media);  // per rolling speed, which the inertia already holds
    if (damping > 1.0 || slowest > 10.0 || are_stiff(media, std::span(&m, 1))) continue;
    reject("angular_speed",
           "below the speed at which the coating radiates waves of order " + text(m) + " that it hardly damps",
           text(angular_speed) + " rad/s");
  }
}

}  // namespace

void require_damped_waves(const CoatedSphere& sphere, double angular_speed, std::span<const double> orders,
                          const std::vector<std::vector<std::complex<double>>>& moduli, Curvature curvature) {
  require_damped_waves(sphere, angular_speed, orders, moduli, curvature, are_stiff_on_sphere);
}

void require_damped_waves(const CoatedCylinder& cylinder, double angular_speed, std::span<const double> orders,
                          const std::vector<std::vector<std::complex<double>>>& moduli) {
  require_damped_waves(layers_about_center(cylinder), angular_speed, orders, moduli, Curvature::sphere,
                       are_stiff_on_cylinder);
}

}  // namespace detail

double critical_speed(const CoatedSphere& sphere, double highest_frequency, Curvature curvature) {
  validate(sphere);
  if (sphere.layers.empty()) return std::numeric_limits<double>::infinity();
  return detail::critical_speed(detail::short_time_media(sphere, highest_frequency, curvature),
                                detail::are_stiff_on_sphere);
}

double critical_speed(const CoatedCylinder& cylinder, double highest_frequency) {
  validate(cylinder);
  return detail::critical_speed(detail::short_time_media(detail::layers_about_center(cylinder), highest_frequency),
                                detail::are_stiff_on_cylinder);
}

}  // namespace viscoroll
