// Public interface of this folder: the full set of influence tables.
#include "viscoroll/influence.hpp"

#include <array>
#include <string>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "influence/table_sums.hpp"

namespace viscoroll {

InfluenceTables influence_tables(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int phi_reach,
                                 int theta_reach, int threads, Curvature curvature, const Observer& observer) {
  validate(mesh);
  const auto require_reach = [](const char* name, int reach, int nodes) {
    detail::require_count(name, reach, 0, nodes / 2, " (at most half of the nodes per revolution)");
  };
  require_reach("phi_reach", phi_reach, mesh.nodes_per_revolution);
  require_reach("theta_reach", theta_reach, theta_nodes_per_revolution(mesh));
  detail::require_thread_count(threads);
  detail::require_orders(curvature);

  using detail::Entry;
  constexpr std::array kAll{Entry::rr, Entry::rphi, Entry::rtheta, Entry::phiphi, Entry::phitheta, Entry::thetatheta};
  std::vector<detail::TableRequest> requests;
  requests.reserve(kAll.size());
  for (const Entry entry : kAll) requests.push_back({.entry = entry});

  detail::Watch watch(observer);
  const detail::CoatingSum sum(detail::checked_layered_body(sphere, curvature), angular_speed, mesh, threads, watch);
  const auto tables = sum.tables(requests, phi_reach, theta_reach, threads, watch);

  InfluenceTables result{.phi_reach = phi_reach, .theta_reach = theta_reach};
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t q = 0; q < 3; ++q) {
      const detail::SignedEntry source = detail::entry_of(p, q);
      const detail::Table& table = tables[static_cast<std::size_t>(source.entry)];
      for (int j = -phi_reach; j <= phi_reach; ++j) {
        for (int l = -theta_reach; l <= theta_reach; ++l) result.values.push_back(source.sign * table(j, l));
      }
    }
  }
  return result;
}

}  // namespace viscoroll
