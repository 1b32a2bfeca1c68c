/// @file
/// @brief Frictionless contact with a rigid plane: who touches, and with which force. Theory.md section 5.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/coating_compliance.hpp"
#include "contact/contact_solution.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Find forces p >= 0 and the plane's position such that the surface touches it where p > 0 and is clear
/// elsewhere: gap = drop - u_y - penetration >= 0, p gap = 0, sum p = load.
struct NormalContactProblem {
  const CoatingCompliance& coating;
  Eigen::ArrayXd drop;  ///< height of each undeformed node above the lowest one [m], >= 0
  double load;          ///< [N], > 0
};

/// @brief Limits of a contact solver.
struct ContactOptions {
  int max_iterations;         ///< linear systems
  Eigen::Index max_unknowns;  ///< that a dense matrix may hold
  int threads;                ///< 0 for all cores
};

/// @brief Active set: drop all tensile nodes; only when there are none, add all overclosed ones; until nothing changes.
/// @param[in] problem coating, shape and load
/// @param[in] start nodes that are in contact at first, at least one
/// @param[in] options limits
/// @param[in] watch progress and cancellation
/// Small contacts are solved by elimination, larger ones by products and a Krylov method unless that fails.
/// @return state whose residual is the largest overclosure, or opening in contact, per penetration
/// @throws std::length_error where elimination is left with more than `max_unknowns` nodes
[[nodiscard]] ContactSolution solve_normal_contact(const NormalContactProblem& problem, std::vector<Eigen::Index> start,
                                                   const ContactOptions& options, Watch& watch);

}  // namespace viscoroll::detail
