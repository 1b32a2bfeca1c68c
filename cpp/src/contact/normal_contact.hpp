/// @file
/// @brief Frictionless contact with a rigid plane: who touches, and with which force. Theory.md section 5.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "influence/convolution.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Find forces p >= 0 and the plane's position such that the surface touches it where p > 0 and is clear
/// elsewhere: gap = profile drop + C p - penetration >= 0, p gap = 0, sum p = load.
struct NormalContactProblem {
  const ScaledConvolution& compliance;  ///< C [m/N]
  Eigen::ArrayXd drop;                  ///< height of each undeformed node above the lowest one [m], >= 0
  double load;                          ///< [N], > 0
};

/// @brief State of the contact.
struct NormalContactSolution {
  Eigen::ArrayXd force;               ///< p at every node [N], 0 out of contact
  Eigen::ArrayXd gap;                 ///< at every node [m]
  std::vector<Eigen::Index> contact;  ///< nodes in contact
  double penetration = 0.0;           ///< of the lowest undeformed node below the plane [m]
  int iterations = 0;                 ///< passes of the active set
  bool converged = false;             ///< nothing tensile, nothing overclosed
  double residual = 0.0;              ///< largest overclosure, or opening in contact, per penetration [-]
};

/// @brief Limits of the active set.
struct NormalContactOptions {
  int max_iterations;      ///< passes
  Eigen::Index max_nodes;  ///< nodes in contact that a dense matrix may hold
  int threads;             ///< 0 for all cores
};

/// @brief Active set: drop all tensile nodes; only when there are none, add all overclosed ones; until nothing changes.
/// @param[in] problem compliance, shape and load
/// @param[in] start nodes that are in contact at first, at least one
/// @param[in] options limits
/// @param[in] watch progress and cancellation
/// @throws std::length_error where more than `max_nodes` nodes come into contact
[[nodiscard]] NormalContactSolution solve_normal_contact(const NormalContactProblem& problem,
                                                         std::vector<Eigen::Index> start,
                                                         const NormalContactOptions& options, Watch& watch);

}  // namespace viscoroll::detail
