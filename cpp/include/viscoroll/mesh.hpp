/// @file
/// @brief The surface mesh.
#pragma once

#include <optional>

namespace viscoroll {

/// @brief Most nodes per revolution of a mesh: with more, a spacing's height is lost in the radius' round-off.
inline constexpr int kMostNodesPerRevolution = 1000000;

/// @brief Surface mesh: nodes at equal spacings in phi and theta, one of them at the lowest point.
struct Mesh {
  int nodes_per_revolution = 0;  ///< 2 pi / spacing along phi, >= 16
  /// N_t: the orders |m|, |n| <= N_t are summed, as in the paper, >= half of the nodes. None: the sum over all orders.
  std::optional<int> max_order;
  std::optional<int> theta_nodes_per_revolution;  ///< 2 pi / spacing along theta; none: as along phi

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// @return 2 pi / spacing along theta
[[nodiscard]] int theta_nodes_per_revolution(const Mesh& mesh);
/// @return angle between neighbors along phi [rad]
[[nodiscard]] double phi_spacing(const Mesh& mesh);
/// @return angle between neighbors along theta [rad]
[[nodiscard]] double theta_spacing(const Mesh& mesh);

/// @brief Check a mesh.
/// @throws std::invalid_argument naming parameter, value and range
void validate(const Mesh& mesh);

}  // namespace viscoroll
