// Public face of this folder: the full set of influence tables.
#include "viscoroll/influence.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "influence/synthesis.hpp"
#include "modal/medium.hpp"
#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "validate.hpp"

namespace viscoroll {

void validate(const Mesh& mesh) {
  // The limits keep the tables of the whole sphere within memory and ints.
  constexpr int kMostNodes = 100000;
  constexpr int kHighestOrder = 200000;
  const auto in_range = [](const char* name, int value, int low, int high, const std::string& why) {
    if (value < low || value > high) {
      detail::reject(name, "in [" + std::to_string(low) + ", " + std::to_string(high) + "]" + why,
                     std::to_string(value));
    }
  };
  in_range("mesh.nodes_per_revolution", mesh.nodes_per_revolution, 16, kMostNodes, "");
  in_range("mesh.max_order", mesh.max_order, (mesh.nodes_per_revolution + 1) / 2, kHighestOrder,
           " (fewer orders than half the nodes per revolution cannot resolve the mesh)");
}

InfluenceTables influence_tables(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int phi_reach,
                                 int theta_reach, int threads, const Observer& observer) {
  validate(mesh);
  for (const auto& [name, reach] : {std::pair("phi_reach", phi_reach), std::pair("theta_reach", theta_reach)}) {
    if (reach < 0 || reach > mesh.nodes_per_revolution / 2) {
      detail::reject(name, "in [0, nodes_per_revolution / 2]", std::to_string(reach));
    }
  }
  detail::require_thread_count(threads);

  using detail::Entry;
  constexpr std::array kAll{Entry::rr, Entry::rphi, Entry::rtheta, Entry::phiphi, Entry::phitheta, Entry::thetatheta};
  std::vector<detail::TableRequest> requests;
  for (const Entry entry : kAll) requests.push_back({.entry = entry});

  detail::Watch watch(observer);
  const detail::HarmonicCoating coating(sphere, angular_speed, detail::orders_up_to(mesh.max_order));
  const auto spectrum = detail::make_spectrum(coating, threads, watch);
  const auto tables =
      detail::synthesize(*spectrum, coating.outer_radius(), mesh, requests, phi_reach, theta_reach, threads, watch);

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
