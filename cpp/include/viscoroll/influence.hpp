/// @file
/// @brief Influence tables: displacement of a surface node by a unit force on the patch of another node.
#pragma once

#include <cstddef>
#include <vector>

#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief The nine influence tables c_PQ(phi_M - phi_N, theta_M - theta_N) with the patch load (53).
struct InfluenceTables {
  int phi_reach = 0;           ///< offsets j in phi run from -phi_reach to phi_reach
  int theta_reach = 0;         ///< offsets l in theta run from -theta_reach to theta_reach
  std::vector<double> values;  ///< [m/N], row-major [P][Q][j][l], P and Q in the order (r, phi, theta)

  /// @brief Displacement in direction `p` by a unit force in direction `q`.
  /// @param[in] p,q directions: 0 for r, 1 for phi, 2 for theta
  /// @param[in] j,l offsets of the displaced node from the loaded node in phi and theta, in spacings
  /// @return displacement per force [m/N]
  [[nodiscard]] double operator()(int p, int q, int j, int l) const {
    const auto row = (static_cast<std::ptrdiff_t>(p) * 3 + q) * (2 * phi_reach + 1) + (j + phi_reach);
    return values[static_cast<std::size_t>(row * (2 * theta_reach + 1) + (l + theta_reach))];
  }
};

/// @brief Compute influence tables by summing the orders of the coating (docs/theory/influence-tables.md).
/// @param[in] sphere core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacing and truncation
/// @param[in] phi_reach,theta_reach largest offsets, in [0, half of the nodes per revolution along phi or theta]
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] curvature `sphere` or `paper`; on the exact sphere the influence is not a function of the offset alone
/// @param[in] observer progress and cancellation
/// @return the tables of all nine pairs of directions
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] InfluenceTables influence_tables(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh,
                                               int phi_reach, int theta_reach, int threads = 0,
                                               Curvature curvature = Curvature::sphere, const Observer& observer = {});

}  // namespace viscoroll
