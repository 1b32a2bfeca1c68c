#include "modal/medium.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "modal/compliance_recursion.hpp"
#include "modal/critical_speed.hpp"
#include "validate.hpp"

namespace viscoroll::detail {

namespace {

using cplx = std::complex<double>;

}  // namespace

bool is_measured(const ShearModulus& modulus) {
  return std::holds_alternative<MasterCurve>(modulus) || std::holds_alternative<CustomModulus>(modulus);
}

std::vector<std::size_t> measured_layers(const std::vector<Layer>& layers) {
  std::vector<std::size_t> measured;
  for (std::size_t j = 0; j < layers.size(); ++j) {
    if (is_measured(layers[j].shear_modulus)) measured.push_back(j);
  }
  return measured;
}

std::vector<std::vector<cplx>> resampled_moduli(const std::vector<Layer>& layers,
                                                const std::vector<double>& frequencies,
                                                const Eigen::ArrayXXcd& measured) {
  std::vector<std::vector<cplx>> moduli;
  moduli.reserve(layers.size());
  Eigen::Index column = 0;
  for (const Layer& layer : layers) {
    if (is_measured(layer.shear_modulus)) {
      const auto values = measured.col(column++);
      moduli.emplace_back(values.begin(), values.end());
    } else {
      moduli.push_back(complex_modulus(layer.shear_modulus, frequencies));
    }
  }
  return moduli;
}

double limited(double order, double limit) { return order / std::pow(1.0 + std::pow(order / limit, 4), 0.25); }

std::vector<std::vector<std::complex<double>>> harmonic_moduli(const std::vector<Layer>& layers, double angular_speed,
                                                               const std::vector<double>& orders,
                                                               double measured_order) {
  std::vector<std::vector<std::complex<double>>> moduli;
  std::vector<double> omega(orders.size());
  for (const Layer& layer : layers) {
    const bool measured = is_measured(layer.shear_modulus);
    std::ranges::transform(orders, omega.begin(),
                           [&](double m) { return angular_speed * (measured ? limited(m, measured_order) : m); });
    moduli.push_back(complex_modulus(layer.shear_modulus, omega));
  }
  return moduli;
}

double highest_frequency(double angular_speed, const std::vector<double>& orders, double measured_order) {
  const double highest = orders.empty() ? 0.0 : std::ranges::max(orders);
  return angular_speed * std::max(1.0, limited(highest, measured_order));
}

HarmonicCoating::HarmonicCoating(const CoatedSphere& sphere, double angular_speed, std::vector<double> orders,
                                 double measured_order, Curvature curvature)
    : sphere_(sphere), angular_speed_(angular_speed), orders_(std::move(orders)), curvature_(curvature) {
  validate(sphere);
  if (sphere.layers.empty()) reject("layers", "a list of at least one layer", "none");
  require_positive("angular_speed", angular_speed, "rad/s");

  radii_.push_back(sphere.core_radius);
  for (const Layer& layer : sphere.layers) radii_.push_back(radii_.back() + layer.thickness);
  moduli_ = harmonic_moduli(sphere.layers, angular_speed, orders_, measured_order);
  require_subcritical(sphere, angular_speed, highest_frequency(angular_speed, orders_, measured_order), curvature);
  require_damped_waves(sphere, angular_speed, orders_, moduli_, curvature);
}

std::vector<std::size_t> HarmonicCoating::measured_layers() const { return detail::measured_layers(sphere_.layers); }

std::unique_ptr<LayeredSurface> HarmonicCoating::resampled(std::vector<double> orders,
                                                           const Eigen::ArrayXXcd& measured) const {
  auto other = std::make_unique<HarmonicCoating>(*this);
  other->orders_ = std::move(orders);
  std::vector<double> omega;
  omega.reserve(other->orders_.size());
  for (const double m : other->orders_) omega.push_back(m * angular_speed_);
  other->moduli_ = resampled_moduli(sphere_.layers, omega, measured);
  return other;
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

void HarmonicCoating::compliances(std::span<const OrderAt> orders, std::span<Eigen::Matrix3cd> compliances) const {
  std::map<std::size_t, std::vector<Medium<cplx>>> layers;
  std::vector<OrderInLayers<cplx>> in_layers;
  in_layers.reserve(orders.size());
  for (const auto& [i, n] : orders) {
    const auto place = layers.try_emplace(i).first;
    if (place->second.empty()) place->second = media(i);
    in_layers.push_back({.media = place->second, .m = orders_[i], .n = n});
  }
  surface_compliances<cplx>(in_layers, compliances);
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
