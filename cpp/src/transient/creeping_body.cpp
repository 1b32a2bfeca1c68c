#include "transient/creeping_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <variant>
#include <vector>

#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// Frequencies at which layers are compared.
std::vector<double> compared_frequencies(const ShearModulus& modulus, const TimeRange& range) {
  constexpr int kCount = 25;
  double low = 1.0 / range.longest;
  double high = 1.0 / range.shortest;
  if (const auto* curve = std::get_if<MasterCurve>(&modulus)) {
    low = std::max(low, *std::ranges::find_if(curve->frequency, [](double w) { return w > 0.0; }));
    high = std::max(std::min(high, curve->frequency.back()), low);
  }
  std::vector<double> frequencies;
  frequencies.reserve(kCount);
  for (int i = 0; i < kCount; ++i)
    frequencies.push_back(std::min(low * std::pow(high / low, i / (kCount - 1.0)), high));
  return frequencies;
}

double relaxed_modulus(const ShearModulus& modulus) { return complex_modulus(modulus, std::array{0.0}).front().real(); }

/// Largest difference of two moduli, each per its value at rest.
double difference(const ShearModulus& a, const ShearModulus& b, std::span<const double> frequencies) {
  const auto values_a = complex_modulus(a, frequencies);
  const auto values_b = complex_modulus(b, frequencies);
  const double ratio = relaxed_modulus(a) / relaxed_modulus(b);
  double largest = 0.0;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    largest = std::max(largest, std::abs(values_a[i] - ratio * values_b[i]) / std::abs(values_a[i]));
  }
  return largest;
}

void rest(Layer& layer) {
  layer.shear_modulus = Elastic{relaxed_modulus(layer.shear_modulus)};
  layer.density = 0.0;
}

void rest(CoatedPlane& plane) {
  for (Layer& layer : plane.layers) rest(layer);
  if (!plane.base) return;
  plane.base->shear_modulus = Elastic{relaxed_modulus(plane.base->shear_modulus)};
  plane.base->density = 0.0;
}

void rest(Groove& groove) { rest(groove.surface); }

/// Of a ball, a roller or a wheel.
template <class Round>
void rest(Round& body) {
  for (Layer& layer : body.layers) rest(layer);
}

template <class Any>
Any rested(Any any) {
  std::visit([](auto& body) { rest(body); }, any);
  return any;
}

}  // namespace

CreepSpectrum common_spectrum(const std::vector<NamedLayer>& layers, std::string_view prefix, const TimeRange& range) {
  constexpr double kSame = 1e-6;
  const ShearModulus& outermost = layers.back().layer.shear_modulus;
  CreepSpectrum spectrum = creep_spectrum(outermost, range);
  for (const auto& [name, layer] : layers) {
    const std::string place = std::string(prefix) + name + ".";
    if (layer.bulk_modulus && spectrum.size() > 0) {
      reject(place + "bulk_modulus",
             "left out in transient rolling (poisson_ratio given instead): with it, creep depends on the order",
             text(*layer.bulk_modulus) + " Pa");
    }
    const double apart = difference(outermost, layer.shear_modulus, compared_frequencies(outermost, range));
    if (apart > kSame) {
      reject(place + "shear_modulus",
             "a multiple of that of the outermost layer in transient rolling (layers that share no relaxation function "
             "creep differently at every order)",
             "a modulus whose share of its value at rest differs by " + rounded(apart));
    }
  }
  return spectrum;
}

RollingBody at_rest(const RollingBody& body) { return rested(body); }

Counterpart at_rest(const Counterpart& on) { return rested(on); }

}  // namespace viscoroll::detail
