/// @file
/// @brief Frictionless contact with a rigid plane: who touches, and with which force. Theory.md section 5.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/coating_compliance.hpp"
#include "contact/contact_solution.hpp"

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
  double tolerance = 1e-11;   ///< relative residual of systems that are solved by products, and of friction per load
};

/// @brief What a normal contact is started from.
struct NormalContactGuess {
  std::vector<Eigen::Index> contact;  ///< nodes, ascending, at least one
  Eigen::ArrayXd pressing;            ///< force on every node [N]
  double penetration;                 ///< [m]
};

/// @brief Active set: drop all tensile nodes; only when there are none, add all overclosed ones; until nothing changes.
///
/// Contacts of up to 100 nodes are solved by elimination. Larger ones are solved by products and a Krylov method, the
/// first sets roughly, unless that fails.
/// @param[in] problem coating, shape and load
/// @param[in] guess to start from
/// @param[in] options limits
/// @return state whose residual is the largest overclosure, or opening in contact, per penetration; displacements are
/// left out
/// @throws std::length_error where elimination is left with more than `max_unknowns` nodes
[[nodiscard]] ContactSolution solve_normal_contact(const NormalContactProblem& problem, const NormalContactGuess& guess,
                                                   const ContactOptions& options);

}  // namespace viscoroll::detail
