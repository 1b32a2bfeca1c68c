#include "influence/mesh_on_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscoroll::detail {
namespace {

int rounded_nodes(int nodes_per_revolution, double turns) {
  constexpr double kFewest = 16.0;
  constexpr double kLargestInt = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(std::round(nodes_per_revolution / turns), kFewest, kLargestInt));
}

}  // namespace

MeshOnBody::MeshOnBody(const Mesh& mesh, double turns) : mesh_(mesh), turns_(turns), rounded_(mesh) {
  rounded_.nodes_per_revolution = rounded_nodes(mesh.nodes_per_revolution, turns);
  if (mesh.theta_nodes_per_revolution) {
    rounded_.theta_nodes_per_revolution = rounded_nodes(*mesh.theta_nodes_per_revolution, turns);
  }
  if (mesh.max_order) rounded_.max_order = static_cast<int>(std::ceil(*mesh.max_order / turns));
}

}  // namespace viscoroll::detail
