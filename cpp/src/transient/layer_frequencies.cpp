#include "transient/layer_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscoroll::detail {
namespace {

std::vector<double> at_equal_ratios(double low, double high, int count) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    values.push_back(std::min(low * std::pow(high / low, i / (count - 1.0)), high));
  }
  return values;
}

}  // namespace

std::vector<double> compared_frequencies(const std::vector<Layer>& layers, const TimeRange& range) {
  constexpr int kCount = 25;
  double low = 1.0 / range.longest;
  double high = 1.0 / range.shortest;
  for (const Layer& layer : layers) {
    const auto* curve = std::get_if<MasterCurve>(&layer.shear_modulus);
    if (curve == nullptr) continue;
    low = std::max(low, *std::ranges::find_if(curve->frequency, [](double w) { return w > 0.0; }));
    high = std::max(std::min(high, curve->frequency.back()), low);
  }
  return at_equal_ratios(low, high, kCount);
}

std::vector<SurfaceOrder> compared_orders(const LayeredBody& body) {
  constexpr int kCount = 25;
  constexpr double kLongest = 0.05;   // wave number times the total thickness
  constexpr double kShortest = 20.0;  // times the smallest thickness: such waves do not reach below that layer
  constexpr double kLowest = 2.0;     // orders 0 and 1 are rigid motions around a center
  double thickness = 0.0;
  double thinnest = std::numeric_limits<double>::infinity();
  for (const Layer& layer : body.layers) {
    if (std::isfinite(layer.thickness)) thickness += layer.thickness;
    thinnest = std::min(thinnest, layer.thickness);
  }
  if (thickness == 0.0) thickness = thinnest = body.metric.radius;  // a half-space, which is the same at all orders
  const double low = std::max(kLongest * body.metric.radius / thickness, body.metric.is_curved() ? kLowest : 0.0);
  const double high = std::max(kShortest * body.metric.radius / thinnest, low);
  std::vector<SurfaceOrder> orders;
  for (const double order : at_equal_ratios(low, high, kCount)) orders.push_back({.m = order, .n = 0.0});
  return orders;
}

}  // namespace viscoroll::detail
