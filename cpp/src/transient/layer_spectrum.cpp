#include "transient/layer_spectrum.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "modal/crown.hpp"
#include "transient/retardation_intervals.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;

/// Whether a viscoelastic layer has an elastic bulk modulus.
bool has_elastic_bulk(const Layer& layer, const CreepFunction& modulus) {
  return layer.bulk_modulus.has_value() && modulus.creep.size() > 0;
}

std::vector<TimeRange> intervals_of(const LayeredBody& body, const std::vector<CreepFunction>& moduli) {
  bool has_elastic_part = false;
  for (std::size_t l = 0; l < moduli.size(); ++l) {
    has_elastic_part = has_elastic_part || has_elastic_bulk(body.layers[l], moduli[l]);
  }
  return retardation_intervals(moduli, has_elastic_part);
}

template <class Scalar, class Modulus>
LayerStack<Scalar> stack_at(const LayeredBody& body, const std::vector<CreepFunction>& moduli, const Modulus& modulus) {
  std::vector<Scalar> values;
  values.reserve(moduli.size());
  for (const CreepFunction& layer : moduli) values.push_back(modulus(layer));
  constexpr double kStill = 0.0;  // without inertia
  return body.stack(values, kStill);
}

template <class Scalar>
std::vector<Matrix3<Scalar>> solved(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown) {
  std::vector<Matrix3<Scalar>> compliances(orders.size());
  surface_compliances<Scalar>(orders, compliances);
  if (!crown.is_flat()) add_crown<Scalar>(orders, crown, compliances);
  return compliances;
}

LayeredBody relaxed(LayeredBody body, const std::vector<CreepFunction>& moduli) {
  for (std::size_t l = 0; l < moduli.size(); ++l) {
    body.layers[l].shear_modulus = Elastic{moduli[l].relaxed};
    body.layers[l].density = 0.0;
  }
  return body;
}

}  // namespace

LayerSpectrum::LayerSpectrum(LayeredBody body, const TimeRange& range, double tolerance)
    : body_(std::move(body)), moduli_(creep_functions(body_.layers, range)) {
  at_rest_ = relaxed(body_, moduli_);
  const std::vector<TimeRange> intervals = intervals_of(body_, moduli_);
  // Orders that do not reach below the outermost layer creep as this layer does, and their kernels are singular. With
  // weights at the own times of this layer only, the tables of the other times stay smooth.
  times_ = common_times(intervals, moduli_.back().creep.retardation_times, tolerance);
  constexpr double kToTheLastDigit = 40.0;
  WeighedContour contour = this->contour(kToTheLastDigit);
  for (const cplx& time : contour.times) on_contour_.push_back(layers_at(time));
  sums_ = std::move(contour.sums);
}

LayerSpectrum::WeighedContour LayerSpectrum::contour(double left) const {
  Contour contour = contour_around(intervals_of(body_, moduli_), left);
  WeighedContour weighed{.times = std::move(contour.times), .sums = {}};
  weighed.sums.resize(static_cast<Index>(times_.size()), static_cast<Index>(weighed.times.size()));
  for (std::size_t q = 0; q < weighed.times.size(); ++q) {
    weighed.sums.col(static_cast<Index>(q)) = contour.weights[q] * shares(times_, weighed.times[q]);
  }
  return weighed;
}

LayerStack<cplx> LayerSpectrum::layers_at(const cplx& time) const {
  return stack_at<cplx>(body_, moduli_, [&](const CreepFunction& layer) { return layer.at(time); });
}

LayerStack<double> LayerSpectrum::layers_at_once() const {
  return stack_at<double>(body_, moduli_, [](const CreepFunction& layer) { return layer.instantaneous(); });
}

LayerSpectrum LayerSpectrum::with_orders_of(double radius) const {
  LayerSpectrum other = *this;
  other.body_.metric.radius = other.at_rest_.metric.radius = radius;
  for (auto& stack : other.on_contour_) stack.metric.radius = radius;
  return other;
}

std::vector<std::vector<Eigen::Matrix3d>> LayerSpectrum::weights_of(std::span<const SurfaceOrder> orders) const {
  const auto at_once = layers_at_once();
  std::vector<OrderInLayers<double>> at_instant;
  std::vector<OrderInLayers<cplx>> creeping;
  for (const SurfaceOrder& order : orders) at_instant.push_back({.layers = at_once, .m = order.m, .n = order.n});
  for (const auto& stack : on_contour_) {
    for (const SurfaceOrder& order : orders) creeping.push_back({.layers = stack, .m = order.m, .n = order.n});
  }
  const auto instantaneous = solved<double>(at_instant, body_.crown);
  const auto compliances = solved<cplx>(creeping, body_.crown);

  std::vector<std::vector<Eigen::Matrix3d>> weights(orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    weights[i].push_back(instantaneous[i]);
    for (Index j = 0; j < sums_.rows(); ++j) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (Index q = 0; q < sums_.cols(); ++q) {
        sum += (sums_(j, q) * compliances[static_cast<std::size_t>(q) * orders.size() + i]).real();
      }
      weights[i].push_back(sum);
    }
  }
  return weights;
}

Eigen::Matrix3cd LayerSpectrum::compliance(std::span<const Eigen::Matrix3d> weights, double omega) const {
  Eigen::Matrix3cd sum = weights.front().cast<cplx>();
  for (std::size_t j = 0; j < times_.size(); ++j) {
    sum += weights[j + 1].cast<cplx>() / cplx(1.0, omega * times_[j]);
  }
  return sum;
}

double LayerSpectrum::error(const TimeRange& range) const {
  const std::vector<SurfaceOrder> orders = compared_orders(body_);
  const std::vector<double> frequencies = compared_frequencies(body_.layers, range);
  const auto weights = weights_of(orders);
  double largest = 0.0;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    for (const double omega : frequencies) {
      const Eigen::Matrix3cd exact = compliance_at(body_, orders[i], omega);
      const Eigen::Array33d apart = (compliance(weights[i], omega) - exact).cwiseAbs();
      const Eigen::Array3d size = exact.diagonal().cwiseAbs().cwiseSqrt();
      largest = std::max(largest, (apart / (size.matrix() * size.matrix().transpose()).array()).maxCoeff());
    }
  }
  return largest;
}

Eigen::Matrix3cd compliance_at(const LayeredBody& body, const SurfaceOrder& order, double omega) {
  std::vector<cplx> moduli;
  moduli.reserve(body.layers.size());
  for (const Layer& layer : body.layers) {
    moduli.push_back(complex_modulus(layer.shear_modulus, std::array{omega}).front());
  }
  const LayerStack<cplx> stack = body.stack(moduli, 0.0);
  const OrderInLayers<cplx> in_layers{.layers = stack, .m = order.m, .n = order.n};
  return solved<cplx>(std::span(&in_layers, 1), body.crown).front();
}

}  // namespace viscoroll::detail
