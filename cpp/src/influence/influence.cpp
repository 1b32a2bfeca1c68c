// Public face of this folder: the full set of influence tables.
#include "viscoroll/influence.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "influence/coating_sum.hpp"
#include "parallel.hpp"
#include "validate.hpp"

namespace viscoroll {

int theta_nodes_per_revolution(const Mesh& mesh) {
  return mesh.theta_nodes_per_revolution.value_or(mesh.nodes_per_revolution);
}

double phi_spacing(const Mesh& mesh) { return 2.0 * std::numbers::pi / mesh.nodes_per_revolution; }

double theta_spacing(const Mesh& mesh) { return 2.0 * std::numbers::pi / theta_nodes_per_revolution(mesh); }

void validate(const Mesh& mesh) {
  constexpr int kFewestNodes = 16;
  constexpr int kHighestOrder = 200000;
  const auto in_range = [](const char* name, int value, int low, int high, const std::string& why) {
    if (value < low || value > high) {
      detail::reject(name, "in [" + std::to_string(low) + ", " + std::to_string(high) + "]" + why,
                     std::to_string(value));
    }
  };
  in_range("mesh.nodes_per_revolution", mesh.nodes_per_revolution, kFewestNodes, kMostNodesPerRevolution, "");
  const int theta_nodes = theta_nodes_per_revolution(mesh);
  in_range("mesh.theta_nodes_per_revolution", theta_nodes, kFewestNodes, kMostNodesPerRevolution, "");
  constexpr int kLargestRatio = 100;  // of spacings; each order of the many would be summed for few offsets
  in_range("mesh.theta_nodes_per_revolution", theta_nodes, mesh.nodes_per_revolution / kLargestRatio,
           mesh.nodes_per_revolution * kLargestRatio, ", a hundred times nodes_per_revolution or a hundredth");
  if (mesh.max_order) {
    in_range("mesh.max_order", *mesh.max_order, (std::max(mesh.nodes_per_revolution, theta_nodes) + 1) / 2,
             kHighestOrder, " (fewer orders than half the nodes per revolution cannot resolve the mesh)");
  }
}

InfluenceTables influence_tables(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int phi_reach,
                                 int theta_reach, int threads, Curvature curvature, const Observer& observer) {
  validate(mesh);
  const auto require_reach = [](const char* name, int reach, int nodes) {
    if (reach < 0 || reach > nodes / 2) {
      detail::reject(name, "in [0, " + std::to_string(nodes / 2) + "], half of the nodes per revolution",
                     std::to_string(reach));
    }
  };
  require_reach("phi_reach", phi_reach, mesh.nodes_per_revolution);
  require_reach("theta_reach", theta_reach, theta_nodes_per_revolution(mesh));
  detail::require_thread_count(threads);
  detail::require_orders(curvature);

  using detail::Entry;
  constexpr std::array kAll{Entry::rr, Entry::rphi, Entry::rtheta, Entry::phiphi, Entry::phitheta, Entry::thetatheta};
  std::vector<detail::TableRequest> requests;
  for (const Entry entry : kAll) requests.push_back({.entry = entry});

  detail::Watch watch(observer);
  const detail::CoatingSum sum(sphere, angular_speed, mesh, threads, watch, curvature);
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
