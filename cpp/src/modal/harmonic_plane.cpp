#include "modal/harmonic_plane.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modal/flat_critical_speed.hpp"
#include "modal/medium.hpp"
#include "validate.hpp"

namespace viscoroll::detail {

using cplx = std::complex<double>;

std::vector<Layer> layers_from_base(const CoatedPlane& plane) {
  std::vector<Layer> layers = plane.layers;
  if (plane.base) {
    layers.insert(layers.begin(), {.thickness = std::numeric_limits<double>::infinity(),
                                   .shear_modulus = plane.base->shear_modulus,
                                   .poisson_ratio = plane.base->poisson_ratio,
                                   .bulk_modulus = plane.base->bulk_modulus,
                                   .density = plane.base->density});
  }
  return layers;
}

HarmonicPlane::HarmonicPlane(const CoatedPlane& plane, double speed, double radius, std::vector<double> orders,
                             double measured_order)
    : speed_(speed), radius_(radius), orders_(std::move(orders)) {
  validate(plane);
  require_positive("speed", speed, "m/s");
  require_positive("radius", radius, "m");
  if (is_rigid(plane)) reject("layers", "a list of at least one layer, or base given", "neither");
  layers_ = layers_from_base(plane);
  const double rate = speed / radius;
  moduli_ = harmonic_moduli(layers_, rate, orders_, measured_order);
  require_subcritical(plane, speed, highest_frequency(rate, orders_, measured_order));
}

std::vector<std::size_t> HarmonicPlane::measured_layers() const { return detail::measured_layers(layers_); }

std::vector<FlatMedium<cplx>> HarmonicPlane::media(std::size_t i) const {
  std::vector<FlatMedium<cplx>> media;
  media.reserve(layers_.size());
  for (std::size_t j = 0; j < layers_.size(); ++j) {
    const cplx mu = modulus(j, i);
    media.push_back({.thickness = layers_[j].thickness,
                     .mu = mu,
                     .b = shear_ratio(layers_[j], mu),
                     .inertia = layers_[j].density * speed_ * speed_});
  }
  return media;
}

std::unique_ptr<LayeredSurface> HarmonicPlane::resampled(std::vector<double> orders,
                                                         const Eigen::ArrayXXcd& measured) const {
  auto other = std::make_unique<HarmonicPlane>(*this);
  other->orders_ = std::move(orders);
  std::vector<double> omega;
  for (const double m : other->orders_) omega.push_back(m * speed_ / radius_);
  other->moduli_ = resampled_moduli(layers_, omega, measured);
  return other;
}

void HarmonicPlane::compliances(std::span<const OrderAt> orders, std::span<Eigen::Matrix3cd> compliances) const {
  for (std::size_t j = 0; j < orders.size(); ++j) {
    const double m = orders_[orders[j].i];
    const double k = std::hypot(m, orders[j].n);
    const double cosine = m / k;
    const auto layers = media(orders[j].i);
    compliances[j] = turned(flat_compliance<cplx>(layers, k / radius_, cosine), cosine, orders[j].n / k);
  }
}

}  // namespace viscoroll::detail
