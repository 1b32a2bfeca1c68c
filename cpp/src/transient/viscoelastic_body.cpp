#include "transient/viscoelastic_body.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "creep/free_sides.hpp"
#include "creep/layer_spectrum.hpp"
#include "creep/order_weights.hpp"
#include "modal/layered_body.hpp"
#include "rolling/contact_surface.hpp"
#include "rolling/free_side_tables.hpp"

namespace viscoroll::detail {
namespace {

/// Add the effect of free faces as far as the tables of the unbounded tread reach; beyond is only the round-off of
/// elements and splines.
void add_sides(std::span<const SampledDifference> differences, const SideSum& sum, const ContactKinematics& kinematics,
               const RowShape& shape, std::vector<MirroredTables>& tables) {
  const SideFactors factors = sum.factors({.phi_reach = static_cast<int>(tables.front().reach())});
  for (std::size_t t = 0; t < tables.size(); ++t) {
    tables[t].superpose(side_influence(differences[t], factors, shape, kinematics.radius * kinematics.theta_spacing));
  }
}

CreepTables tables_of_similar_layers(const Body& at_rest, const ContactKinematics& kinematics, const RowShape& shape) {
  const auto& [threads, watch] = kinematics.execution;
  const LayeredBody layers = at_rest.layered(kinematics);
  const auto sum = sum_of_orders(layers, kinematics);
  std::vector<MirroredTables> tables;
  tables.emplace_back(*sum, shape, threads, watch);  // an initializer list would copy
  if (at_rest.free_tread() != nullptr) {
    const double radius = layers.metric.radius;
    const SideSum sides =
        sum_of_sides(*at_rest.free_tread(), layers,
                     {.mesh = kinematics.mesh_at(radius), .angular_speed = kinematics.angular_speed_at(radius)},
                     shape.components > 1, kinematics.execution);
    add_sides({sides.difference().get(), 1}, sides, kinematics, shape, tables);
  }
  return CreepTables(std::move(tables));
}

CreepTables tables_of_dissimilar_layers(const Body& at_rest, const LayerSpectrum& layers,
                                        const ContactKinematics& kinematics, const RowShape& shape) {
  const auto& [threads, watch] = kinematics.execution;
  const MeshOnBody mesh = kinematics.mesh_at(layers.metric().radius);
  const auto sums = kinematics.form.is_line() ? weights_under_line(layers, mesh, threads, watch)
                                              : weights_under_spot(layers, mesh, threads, watch);
  std::vector<MirroredTables> tables = MirroredTables::of_all(sums, shape, threads, watch);
  if (at_rest.free_tread() != nullptr) {
    const auto weights = side_weights(layers, *at_rest.free_tread(), shape.components > 1, threads, watch);
    add_sides(*weights, sum_of_side_weights(weights, layers, mesh), kinematics, shape, tables);
  }
  return CreepTables(std::move(tables));
}

std::vector<Layer> layers_of(const std::vector<NamedLayer>& named) {
  std::vector<Layer> layers;
  layers.reserve(named.size());
  for (const NamedLayer& layer : named) layers.push_back(layer.layer);
  return layers;
}

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

void relax(CoatedPlane& plane) {
  for (Layer& layer : plane.layers) relax_layer(layer);
  if (!plane.base) return;
  plane.base->shear_modulus = Elastic{relaxed_modulus(plane.base->shear_modulus)};
  plane.base->density = 0.0;
}

void relax(Groove& groove) { relax(groove.surface); }

/// Relax the layers of a ball, a roller or a wheel.
template <class Body>
void relax(Body& body) {
  for (Layer& layer : body.layers) relax_layer(layer);
}

template <class BodyVariant>
BodyVariant relaxed(BodyVariant any_body) {
  std::visit([](auto& body) { relax(body); }, any_body);
  return any_body;
}

}  // namespace

double CreepTables::diagonal_compliance() const {
  double sum = 0.0;
  for (const MirroredTables& tables : *tables_) sum += tables.diagonal_compliance();
  return sum;
}

InstantaneousTables CreepTables::instantaneous(std::vector<double> parts,
                                               const std::function<void()>& checkpoint) const {
  if (count() == 1) {
    const double share = parts.front();
    return {.parts = std::move(parts), .share = share, .tables = {tables_, &tables_->front()}};
  }
  auto tables = std::make_shared<const MirroredTables>(MirroredTables::sum_of(*tables_, parts, checkpoint));
  return {.parts = std::move(parts), .share = 1.0, .tables = std::move(tables)};
}

CreepTables tables_of(const Body& at_rest, const LayerSpectrum* dissimilar_layers, const ContactKinematics& kinematics,
                      const RowShape& shape) {
  if (dissimilar_layers == nullptr) return tables_of_similar_layers(at_rest, kinematics, shape);
  const double radius = at_rest.layered(kinematics).metric.radius;
  return tables_of_dissimilar_layers(at_rest, dissimilar_layers->with_orders_of(radius), kinematics, shape);
}

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
