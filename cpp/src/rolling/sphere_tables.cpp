#include "rolling/sphere_tables.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "surface/corrected_operator.hpp"

namespace viscoroll::detail {

std::shared_ptr<const SurfaceOperator> SphereTables::operator_on(const SurfaceWindow& nodes,
                                                                 const Formulation& formulation,
                                                                 const Execution& execution) const {
  SphereRequest request{.tangential = formulation.tangential || formulation.compliance == Compliance::vertical,
                        .power = false,
                        .patch_load = formulation.patch_load,
                        .collocation = formulation.collocation};
  const auto& [phi, theta] = nodes.window();
  require_few_values(request, phi.count() - 1, theta.last);
  auto influence = this->influence(request, phi.count() - 1, theta.last, execution);
  Formulation flat = formulation;
  flat.patch_load = PatchLoad::flat;
  auto nearby = std::make_shared<const TableOperator>(
      flat, nodes.grid(), nodes.window(), std::make_shared<const std::vector<Table>>(tables_around_equator(*influence)),
      TableOperator::DissipationSource{}, execution);
  request.power = true;
  return std::make_shared<SphereOperator>(std::move(nearby), std::move(influence),
                                          [this, request, execution](int phi_reach, int half_theta) {
                                            return this->influence(request, phi_reach, half_theta, execution);
                                          });
}

void SphereTables::require_few_values(const SphereRequest& request, int phi_reach, int half_theta) const {
  const double values = sum_.values(request, phi_reach, half_theta);
  if (values <= kMaxSphereValues) return;
  const std::string most = text(kMaxSphereValues) + " values of harmonics and tables";
  const std::string made = text(values) + " with curvature EXACT";
  if (mesh_.max_order) {
    reject("mesh.max_order", "so small that the mesh needs at most " + most,
           std::to_string(*mesh_.max_order) + " (" + made + ")");
  }
  throw MeshTooFine(mesh_.nodes_per_revolution, most, made);
}

std::shared_ptr<const SphereInfluence> SphereTables::influence(const SphereRequest& request, int phi_reach,
                                                               int half_theta, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  const auto found = std::ranges::find(entries_, request, &Entry::request);
  if (found != entries_.end()) {
    const SphereInfluence& widest = *found->influence;
    if (widest.phi_reach >= phi_reach && widest.half_theta() >= half_theta) return found->influence;
    phi_reach = std::max(phi_reach, widest.phi_reach);
    half_theta = std::max(half_theta, widest.half_theta());
  }
  // Displacements and dissipation are both needed, and one local metric serves both sums.
  std::vector<SphereRequest> requests{request, request};
  requests.back().power = !request.power;
  auto influences = sum_.influences(requests, phi_reach, half_theta, execution.threads, execution.watch);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.request == requests[i]; });
    entries_.push_back(
        {.request = requests[i], .influence = std::make_shared<const SphereInfluence>(std::move(influences[i]))});
  }
  return std::ranges::find(entries_, request, &Entry::request)->influence;
}

}  // namespace viscoroll::detail
