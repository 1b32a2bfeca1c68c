#include "transient/viscoelastic_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <variant>
#include <vector>

#include "transient/layer_frequencies.hpp"

namespace viscoroll::detail {
namespace {

std::vector<Layer> layers_of(const std::vector<NamedLayer>& named) {
  std::vector<Layer> layers;
  layers.reserve(named.size());
  for (const NamedLayer& one : named) layers.push_back(one.layer);
  return layers;
}

double relaxed_modulus(const ShearModulus& modulus) { return complex_modulus(modulus, std::array{0.0}).front().real(); }

/// Largest relative difference of two moduli, each divided by its relaxed value.
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

/// Relax the layers of a ball, a roller or a wheel.
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

bool creep_alike(const std::vector<NamedLayer>& layers, const TimeRange& range) {
  constexpr double kSame = 1e-6;
  const ShearModulus& outermost = layers.back().layer.shear_modulus;
  const std::vector<double> frequencies = compared_frequencies(layers_of(layers), range);
  return std::ranges::all_of(layers, [&](const NamedLayer& named) {
    const Layer& layer = named.layer;
    const bool has_elastic_bulk = layer.bulk_modulus && !std::holds_alternative<Elastic>(layer.shear_modulus);
    return !has_elastic_bulk && difference(outermost, layer.shear_modulus, frequencies) <= kSame;
  });
}

std::vector<double> ViscoelasticBody::parts_at_once() const {
  std::vector<double> parts(tables.count(), 0.0);
  parts.front() = spectrum.instantaneous;
  return parts;
}

std::vector<double> ViscoelasticBody::parts_at_rest() const { return std::vector(tables.count(), 1.0); }

std::vector<double> ViscoelasticBody::parts_after(const TimeStep& step) const {
  if (tables.count() == 1) return {step.compliance};
  std::vector<double> parts = parts_at_once();
  for (std::size_t j = 0; j < step.terms.size(); ++j) {
    parts[tables.of_term(j)] = step.terms[j].weight * step.terms[j].on_new;
  }
  return parts;
}

RollingBody at_rest(const RollingBody& body) { return rested(body); }

Counterbody at_rest(const Counterbody& on) { return rested(on); }

}  // namespace viscoroll::detail
