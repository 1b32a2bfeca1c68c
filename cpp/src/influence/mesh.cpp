#include "viscoroll/mesh.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "base/validate.hpp"

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
  in_range("mesh.nodes_per_revolution", mesh.nodes_per_revolution, kFewestNodes, kMaxNodesPerRevolution, "");
  const int theta_nodes = theta_nodes_per_revolution(mesh);
  in_range("mesh.theta_nodes_per_revolution", theta_nodes, kFewestNodes, kMaxNodesPerRevolution, "");
  constexpr int kLargestRatio = 100;  // ratio of spacings; beyond it, many orders would be summed for few offsets
  in_range("mesh.theta_nodes_per_revolution", theta_nodes, mesh.nodes_per_revolution / kLargestRatio,
           mesh.nodes_per_revolution * kLargestRatio, " (between 1/100 and 100 times nodes_per_revolution)");
  if (mesh.max_order) {
    in_range("mesh.max_order", *mesh.max_order, (std::max(mesh.nodes_per_revolution, theta_nodes) + 1) / 2,
             kHighestOrder, " (fewer orders than half the nodes per revolution cannot resolve the mesh)");
  }
}

}  // namespace viscoroll
