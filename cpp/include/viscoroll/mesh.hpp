/// @file
/// @brief Surface mesh.
#pragma once

#include <optional>
#include <tuple>

#include "viscoroll/fields.hpp"

namespace viscoroll {

/// @brief Largest number of nodes per revolution. On finer meshes the height difference over a spacing is lost in the
/// round-off of the radius.
inline constexpr int kMaxNodesPerRevolution = 1000000;

/// @brief Surface mesh: nodes at equal spacings in phi and theta, one of them at the lowest point.
struct Mesh {
  int nodes_per_revolution = 0;  ///< 2 pi / spacing along phi, >= 16
  /// Truncation order N_t: influence tables contain the orders |m|, |n| <= N_t, as in the paper; at least half of the
  /// nodes per revolution. None: the sum over all orders.
  std::optional<int> max_order;
  std::optional<int> theta_nodes_per_revolution;  ///< 2 pi / spacing along theta; none: the same as along phi

  static constexpr auto fields() {
    return std::tuple{Field{"nodes_per_revolution", &Mesh::nodes_per_revolution}, Field{"max_order", &Mesh::max_order},
                      Field{"theta_nodes_per_revolution", &Mesh::theta_nodes_per_revolution}};
  }

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// @return 2 pi / spacing along theta
[[nodiscard]] int theta_nodes_per_revolution(const Mesh& mesh);
/// @return angle between neighboring nodes along phi [rad]
[[nodiscard]] double phi_spacing(const Mesh& mesh);
/// @return angle between neighboring nodes along theta [rad]
[[nodiscard]] double theta_spacing(const Mesh& mesh);

/// @brief Check a mesh.
/// @throws InvalidInput naming parameter, value and range
void validate(const Mesh& mesh);

}  // namespace viscoroll
