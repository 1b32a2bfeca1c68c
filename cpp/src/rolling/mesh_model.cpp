#include "rolling/mesh_model.hpp"

#include <algorithm>
#include <iterator>

#include "viscoroll/modal.hpp"

namespace viscoroll::detail {

MeshModel::MeshModel(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int threads, Watch& watch)
    : orders_(sphere, angular_speed, mesh, threads, watch),
      centrifugal_(centrifugal_displacement(sphere, angular_speed)) {}

CoatingTables MeshModel::tables(const Formulation& formulation, int phi_reach, int theta_reach,
                                const Execution& execution) const {
  const std::scoped_lock lock(mutex_);
  const auto set = std::find_if(sets_.begin(), sets_.end(), [&](const TableSet& s) { return s.formulation == formulation; });
  if (set != sets_.end()) {
    if (set->phi_reach >= phi_reach && set->theta_reach >= theta_reach) return set->tables;
    // Rising loads are to ask for few sets.
    phi_reach = std::min(std::max(phi_reach, 3 * set->phi_reach / 2), mesh().nodes_per_revolution / 2);
    theta_reach = std::min(std::max(theta_reach, 3 * set->theta_reach / 2), theta_nodes_per_revolution(mesh()) / 2);
  }

  // One sum for both, since they share the compliance of every order.
  auto requests = displacement_tables(formulation);
  const auto displacements = static_cast<std::ptrdiff_t>(requests.size());
  const auto lost_work = lost_work_tables(formulation);
  requests.insert(requests.end(), lost_work.begin(), lost_work.end());
  std::vector<Table> tables =
      orders_.tables(requests, phi_reach, theta_reach, execution.threads, execution.watch);
  const auto middle = std::make_move_iterator(tables.begin() + displacements);
  const CoatingTables made{
      .displacement =
          std::make_shared<const std::vector<Table>>(std::make_move_iterator(tables.begin()), middle),
      .lost_work = std::make_shared<const std::vector<Table>>(middle, std::make_move_iterator(tables.end()))};
  if (set != sets_.end()) sets_.erase(set);
  sets_.push_back({.formulation = formulation, .phi_reach = phi_reach, .theta_reach = theta_reach, .tables = made});
  return made;
}

}  // namespace viscoroll::detail
