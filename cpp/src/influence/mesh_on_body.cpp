#include "influence/mesh_on_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
  constexpr int kMinNodes = 16;
  constexpr int kHighestOrder = 200000;
  detail::require_count("mesh.nodes_per_revolution", mesh.nodes_per_revolution, kMinNodes, kMaxNodesPerRevolution);
  const int theta_nodes = theta_nodes_per_revolution(mesh);
  detail::require_count("mesh.theta_nodes_per_revolution", theta_nodes, kMinNodes, kMaxNodesPerRevolution);
  constexpr int kLargestRatio = 100;  // ratio of spacings; beyond it, many orders would be summed for few offsets
  detail::require_count("mesh.theta_nodes_per_revolution", theta_nodes, mesh.nodes_per_revolution / kLargestRatio,
                        mesh.nodes_per_revolution * kLargestRatio,
                        " (between 1/100 and 100 times nodes_per_revolution)");
  if (mesh.max_order) {
    detail::require_count("mesh.max_order", *mesh.max_order, (std::max(mesh.nodes_per_revolution, theta_nodes) + 1) / 2,
                          kHighestOrder, " (fewer orders than half the nodes per revolution cannot resolve the mesh)");
  }
}

}  // namespace viscoroll

namespace viscoroll::detail {
namespace {

constexpr double kBothSides = 2.0 / 3.0 * std::numbers::pi;  // 60 degrees on either side

int rounded_nodes(double nodes_per_revolution) {
  constexpr double kMinRoundedNodes = 16.0;
  constexpr double kLargestInt = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(std::round(nodes_per_revolution), kMinRoundedNodes, kLargestInt));
}

}  // namespace

MeshOnBody::MeshOnBody(const Mesh& mesh, double turns)
    : MeshOnBody(mesh, turns, viscoroll::theta_spacing(mesh), kBothSides) {}

MeshOnBody::MeshOnBody(const Mesh& mesh, double turns, double theta_spacing, double widest)
    : mesh_(mesh), turns_(turns), theta_spacing_(theta_spacing), widest_(widest), rounded_(mesh) {
  rounded_.nodes_per_revolution = rounded_nodes(mesh.nodes_per_revolution / turns);
  if (mesh.theta_nodes_per_revolution || theta_spacing != viscoroll::theta_spacing(mesh)) {
    rounded_.theta_nodes_per_revolution = rounded_nodes(2.0 * std::numbers::pi / (turns * theta_spacing));
  }
  if (mesh.max_order) rounded_.max_order = static_cast<int>(std::ceil(*mesh.max_order / turns));
}

}  // namespace viscoroll::detail
