#include "rolling/sphere_tables.hpp"

#include <algorithm>

namespace viscoroll::detail {

std::shared_ptr<const std::vector<SphereTable>> SphereTables::tables(const SphereRequest& request, int phi_reach,
                                                                     int half_theta, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  const auto same = [&](const Set& set) { return set.request == request; };
  const auto found = std::ranges::find_if(sets_, same);
  if (found != sets_.end()) {
    const SphereTable& table = found->tables->front();
    const int half = (table.theta_nodes() - 1) / 2;
    if (table.phi_reach() >= phi_reach && half >= half_theta) return found->tables;
    phi_reach = std::max(phi_reach, table.phi_reach());
    half_theta = std::max(half_theta, half);
    sets_.erase(found);
  }
  auto tables = std::make_shared<const std::vector<SphereTable>>(
      sum_.tables(request, phi_reach, half_theta, execution.threads, execution.watch));
  sets_.push_back({.request = request, .tables = tables});
  return tables;
}

}  // namespace viscoroll::detail
