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
  for (const NamedLayer& layer : named) layers.push_back(layer.layer);
  return layers;
}

double relaxed_modulus(const ShearModulus& modulus) { return complex_modulus(modulus, std::array{0.0}).front().real(); }

/// Largest relative difference of two moduli, each divided by its relaxed value.
double relative_difference(const ShearModulus& a, const ShearModulus& b, std::span<const double> frequencies) {
  const auto values_a = complex_modulus(a, frequencies);
  const auto values_b = complex_modulus(b, frequencies);
  const double ratio = relaxed_modulus(a) / relaxed_modulus(b);
  double largest = 0.0;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    largest = std::max(largest, std::abs(values_a[i] - ratio * values_b[i]) / std::abs(values_a[i]));
  }
  return largest;
}

/// Replace a modulus by its relaxed value, and remove inertia.
void relax(Layer& layer) {
  layer.shear_modulus = Elastic{relaxed_modulus(layer.shear_modulus)};
  layer.density = 0.0;
}

void relax(CoatedPlane& plane) {
  for (Layer& layer : plane.layers) relax(layer);
  if (!plane.base) return;
  plane.base->shear_modulus = Elastic{relaxed_modulus(plane.base->shear_modulus)};
  plane.base->density = 0.0;
}

void relax(Groove& groove) { relax(groove.surface); }

/// Relax the layers of a ball, a roller or a wheel.
template <class Body>
void relax(Body& body) {
  for (Layer& layer : body.layers) relax(layer);
}

template <class BodyVariant>
BodyVariant relaxed(BodyVariant any_body) {
  std::visit([](auto& body) { relax(body); }, any_body);
  return any_body;
}

}  // namespace

bool creep_identically(const std::vector<NamedLayer>& layers, const TimeRange& range) {
  constexpr double kMaxDifference = 1e-6;
  const ShearModulus& outermost = layers.back().layer.shear_modulus;
  const std::vector<double> frequencies = compared_frequencies(layers_of(layers), range);
  return std::ranges::all_of(layers, [&](const NamedLayer& named) {
    const Layer& layer = named.layer;
    const bool has_elastic_bulk = layer.bulk_modulus && !std::holds_alternative<Elastic>(layer.shear_modulus);
    return !has_elastic_bulk && relative_difference(outermost, layer.shear_modulus, frequencies) <= kMaxDifference;
  });
}

std::vector<double> ViscoelasticBody::instantaneous_factors() const {
  std::vector<double> factors(tables.count(), 0.0);
  factors.front() = spectrum.instantaneous;
  return factors;
}

std::vector<double> ViscoelasticBody::relaxed_factors() const { return std::vector(tables.count(), 1.0); }

std::vector<double> ViscoelasticBody::step_factors(const TimeStep& step) const {
  if (tables.count() == 1) return {step.compliance};
  std::vector<double> factors = instantaneous_factors();
  for (std::size_t j = 0; j < step.terms.size(); ++j) {
    factors[tables.of_term(j)] = step.terms[j].weight * step.terms[j].on_new;
  }
  return factors;
}

RollingBody with_relaxed_moduli(const RollingBody& body) { return relaxed(body); }

Counterbody with_relaxed_moduli(const Counterbody& on) { return relaxed(on); }

}  // namespace viscoroll::detail
