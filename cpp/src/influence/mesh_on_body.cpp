#include "influence/mesh_on_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace viscoroll::detail {
namespace {

constexpr double kBothSides = 2.0 / 3.0 * std::numbers::pi;  // 60 degrees on either side

int rounded_nodes(double nodes_per_revolution) {
  constexpr double kFewest = 16.0;
  constexpr double kLargestInt = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(std::round(nodes_per_revolution), kFewest, kLargestInt));
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
