/// @file
/// @brief Frictionless contact: who touches, and with which force. See docs/theory/normal-contact.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief What a normal contact is started from.
struct NormalContactGuess {
  std::vector<Eigen::Index> contact;  ///< nodes, ascending, at least one
  Eigen::ArrayXd pressing;            ///< force on every node [N]
  double penetration;                 ///< [m]
};

/// @brief Active set whose systems are solved by products and a Krylov method, the first ones roughly, or between few
/// nodes by a matrix.
/// @param[in] problem surface, initial gap and normal force; friction is left out
/// @param[in] guess to start from
/// @param[in] options limits
/// @return state whose residual is the largest overclosure, or opening in contact, per penetration; displacements are
/// left out
[[nodiscard]] ContactSolution solve_normal_contact(const ContactProblem& problem, const NormalContactGuess& guess,
                                                   const ContactOptions& options);

/// @brief The forces on given nodes, which stay in contact whatever comes of it: tension, too, and overclosure beside.
/// @param[in] problem surface, initial gap and normal force; friction is left out
/// @param[in] guess the nodes, and forces to start from
/// @param[in] options limits
[[nodiscard]] ContactSolution press_kept_nodes(const ContactProblem& problem, const NormalContactGuess& guess,
                                               const ContactOptions& options);

}  // namespace viscoroll::detail
