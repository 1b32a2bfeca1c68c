#include "rolling/mesh_model.hpp"

#include <algorithm>
#include <numbers>

#include "influence/synthesis.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll::detail {

MeshModel::MeshModel(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int threads, Watch& watch)
    : coating_(sphere, angular_speed, orders_up_to(mesh.max_order)),
      mesh_(mesh),
      spacing_(2.0 * std::numbers::pi / mesh.nodes_per_revolution),
      centrifugal_(centrifugal_displacement(sphere, angular_speed)),
      spectrum_(make_spectrum(coating_, threads, watch)) {}

std::shared_ptr<const std::vector<Table>> MeshModel::tables(const Formulation& formulation, int reach, int threads,
                                                            Watch& watch) const {
  const auto requests = required_tables(formulation);
  const std::scoped_lock lock(mutex_);
  auto set = std::find_if(sets_.begin(), sets_.end(), [&](const TableSet& s) { return s.requests == requests; });
  if (set != sets_.end() && set->reach >= reach) return set->tables;
  auto tables = std::make_shared<const std::vector<Table>>(
      synthesize(*spectrum_, radius(), mesh_, requests, reach, reach, threads, watch));
  if (set == sets_.end()) set = sets_.insert(set, {.requests = requests, .reach = 0, .tables = nullptr});
  set->reach = reach;
  set->tables = tables;
  return tables;
}

}  // namespace viscoroll::detail
