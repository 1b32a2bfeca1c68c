/// @file
/// @brief Cohesive zone with the cubic traction law at a straight edge of a contact that rolls steadily:
/// docs/theory/adhesion.md, "Edges finer than the mesh".
#pragma once

#include <vector>

namespace viscoroll::detail {

/// @brief Creep compliance of a contact on the scale of its edges, J(t) = J_0 + sum_j J_j (1 - exp(-t / lambda_j)): the
/// sum of 1/E*, with E* = 2 G / (1 - nu), of the outermost layers of both bodies.
struct EdgeCreep {
  double instantaneous = 0.0;                  ///< J_0 [1/Pa]
  std::vector<double> delayed = {};            ///< J_j [1/Pa]
  std::vector<double> retardation_times = {};  ///< lambda_j [s]

  /// @return J_0 + sum_j J_j [1/Pa]
  [[nodiscard]] double relaxed() const;
  /// @return J(t) [1/Pa]
  [[nodiscard]] double after(double time) const;
};

/// @brief Edge whose cohesive zone has the length 1 and the peak 1. The work is proportional to the length and to the
/// square of the peak, the stress intensity to the square root of the length and to the peak.
struct CohesiveEdge {
  double work;       ///< work of adhesion [1/Pa]
  double intensity;  ///< K of the traction at an opening edge [-], K_c of the strain at a closing edge [1/Pa]
};

/// @brief Edge at which the surfaces separate. The traction is elastic, and the gap creeps.
/// @param[in] creep creep compliance at the edge
/// @param[in] time time in which material passes the zone, may be infinite [s]
/// @param[in] regular B l / K: next term B sqrt(r) of the pressure ahead of the edge, times the length l of the zone,
/// relative to the stress intensity [-], >= 0
[[nodiscard]] CohesiveEdge opening_edge(const EdgeCreep& creep, double time, double regular = 0.0);

/// @brief Edge at which the surfaces come together. The gap is elastic in terms of the strain that the traction causes.
/// @param[in] creep creep compliance at the edge
/// @param[in] time time in which material passes the zone, may be infinite [s]
/// @param[in] regular the same as for the opening edge, in terms of the strain [-], >= 0
[[nodiscard]] CohesiveEdge closing_edge(const EdgeCreep& creep, double time, double regular = 0.0);

}  // namespace viscoroll::detail
