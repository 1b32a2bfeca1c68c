#include "modal/medium.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modal/critical_speed.hpp"
#include "validate.hpp"

namespace viscoroll::detail {

namespace {

bool is_measured(const ShearModulus& modulus) {
  return std::holds_alternative<MasterCurve>(modulus) || std::holds_alternative<CustomModulus>(modulus);
}

/// Orders that approach a limit smoothly: series over them stay smooth.
double limited(double order, double limit) { return order / std::pow(1.0 + std::pow(order / limit, 4), 0.25); }

}  // namespace

HarmonicCoating::HarmonicCoating(const CoatedSphere& sphere, double angular_speed, std::vector<double> orders,
                                 double measured_order, Curvature curvature)
    : sphere_(sphere), angular_speed_(angular_speed), orders_(std::move(orders)), curvature_(curvature) {
  validate(sphere);
  require_positive("angular_speed", angular_speed, "rad/s");

  radii_.push_back(sphere.core_radius);
  std::vector<double> omega(orders_.size());
  for (const Layer& layer : sphere.layers) {
    radii_.push_back(radii_.back() + layer.thickness);
    const bool measured = is_measured(layer.shear_modulus);
    std::ranges::transform(orders_, omega.begin(),
                           [&](double m) { return angular_speed * (measured ? limited(m, measured_order) : m); });
    moduli_.push_back(complex_modulus(layer.shear_modulus, omega));
  }
  const double highest = orders_.empty() ? 0.0 : std::ranges::max(orders_);
  require_subcritical(sphere, angular_speed, angular_speed * std::max(1.0, limited(highest, measured_order)),
                      curvature);
  require_damped_waves(sphere, angular_speed, orders_, moduli_, curvature);
}

HarmonicCoating HarmonicCoating::at(std::vector<double> orders, const Eigen::ArrayXXcd& measured) const {
  HarmonicCoating other(*this);
  other.orders_ = std::move(orders);
  std::vector<double> omega;
  omega.reserve(other.orders_.size());
  for (const double m : other.orders_) omega.push_back(m * angular_speed_);
  Eigen::Index column = 0;
  for (std::size_t j = 0; j < moduli_.size(); ++j) {
    const ShearModulus& modulus = sphere_.layers[j].shear_modulus;
    if (is_measured(modulus)) {
      const auto values = measured.col(column++);
      other.moduli_[j].assign(values.begin(), values.end());
    } else {
      other.moduli_[j] = complex_modulus(modulus, omega);
    }
  }
  return other;
}

std::vector<std::size_t> HarmonicCoating::measured_layers() const {
  std::vector<std::size_t> layers;
  for (std::size_t j = 0; j < sphere_.layers.size(); ++j) {
    if (is_measured(sphere_.layers[j].shear_modulus)) layers.push_back(j);
  }
  return layers;
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
                     .inertia = layer.density * angular_speed_ * angular_speed_,
                     .curvature = curvature_});
  }
  media.front().within = sphere_.inner_boundary;
  return media;
}

HarmonicCoating coating_at_rest(const CoatedSphere& sphere, double angular_speed, Curvature curvature) {
  return {sphere, angular_speed, {0.0}, std::numeric_limits<double>::infinity(), curvature};
}

void require_orders(Curvature curvature) {
  if (curvature == Curvature::exact) {
    reject("curvature", "SPHERE or PAPER here, where orders (m, n) are meant", "EXACT");
  }
}

}  // namespace viscoroll::detail
