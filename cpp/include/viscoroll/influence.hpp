/// @file
/// @brief Influence tables: displacement at one surface node by a unit load on the patch of another.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "viscoroll/observer.hpp"
#include "viscoroll/sphere.hpp"

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

/// @brief The 3 x 3 set of influence tables c_PQ(phi_M - phi_N, theta_M - theta_N) with the patch load (53).
struct InfluenceTables {
  int phi_reach = 0;           ///< offsets j in phi run from -phi_reach to phi_reach
  int theta_reach = 0;         ///< offsets l in theta run from -theta_reach to theta_reach
  std::vector<double> values;  ///< [m/N], row-major [P][Q][j][l], P and Q in the order (r, phi, theta)

  /// @brief Displacement in direction `p` by a unit force in direction `q`.
  /// @param[in] p,q 0, 1, 2 for r, phi, theta
  /// @param[in] j,l offset of the displaced node from the loaded node, in spacings
  /// @return [m/N]
  [[nodiscard]] double operator()(int p, int q, int j, int l) const {
    const auto row = (static_cast<std::ptrdiff_t>(p) * 3 + q) * (2 * phi_reach + 1) + (j + phi_reach);
    return values[static_cast<std::size_t>(row * (2 * theta_reach + 1) + (l + theta_reach))];
  }
};

/// @brief Sum the orders of the coating into influence tables, theory.md section 4.
/// @param[in] sphere rigid core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacing and truncation
/// @param[in] phi_reach,theta_reach largest offsets, in [0, half of the nodes per revolution along phi or theta]
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] curvature sphere or paper: on the exact sphere influence is no function of the offset alone
/// @param[in] observer progress and cancellation
/// @throws std::invalid_argument for bad input
[[nodiscard]] InfluenceTables influence_tables(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh,
                                               int phi_reach, int theta_reach, int threads = 0,
                                               Curvature curvature = Curvature::sphere, const Observer& observer = {});

}  // namespace viscoroll
