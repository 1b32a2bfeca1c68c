#include "transient/body_tables.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "rolling/free_side_tables.hpp"
#include "rolling/line_contact_surface.hpp"
#include "rolling/point_contact_surface.hpp"
#include "transient/side_influence.hpp"
#include "transient/side_weights.hpp"
#include "transient/weight_sums.hpp"

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
  const auto sum = kinematics.form.is_line() ? sum_under_line(layers, kinematics) : sum_under_spot(layers, kinematics);
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

}  // namespace

CreepTables tables_of(const Body& at_rest, const LayerSpectrum* dissimilar_layers, const ContactKinematics& kinematics,
                      const RowShape& shape) {
  if (dissimilar_layers == nullptr) return tables_of_similar_layers(at_rest, kinematics, shape);
  const double radius = at_rest.layered(kinematics).metric.radius;
  return tables_of_dissimilar_layers(at_rest, dissimilar_layers->with_orders_of(radius), kinematics, shape);
}

}  // namespace viscoroll::detail
