/// @file
/// @brief Frictionless contact: nodes in contact and their forces. See docs/theory/normal-contact.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief Start of a frictionless contact.
struct NormalContactGuess {
  std::vector<Eigen::Index> contact;  ///< nodes in contact, ascending, at least one
  Eigen::ArrayXd pressing;            ///< force on every node [N]
  double penetration;                 ///< penetration [m]
};

/// @brief Solve a frictionless contact with an active set.
/// The linear systems are solved iteratively with operator applications, at first approximately. Systems of few nodes
/// use a dense matrix.
/// @param[in] problem surface, initial gap and load; friction is ignored
/// @param[in] guess start
/// @param[in] options limits
/// @return state without displacements; its residual is the largest overclosure, or gap in contact, per penetration
[[nodiscard]] ContactSolution solve_normal_contact(const ContactProblem& problem, const NormalContactGuess& guess,
                                                   const ContactOptions& options);

/// @brief Solve for the forces on given nodes, which stay in contact even under tension, while other nodes may be
/// overclosed.
/// @param[in] problem surface, initial gap and load; friction is ignored
/// @param[in] guess nodes in contact and initial forces
/// @param[in] options limits
[[nodiscard]] ContactSolution solve_given_nodes(const ContactProblem& problem, const NormalContactGuess& guess,
                                                const ContactOptions& options);

}  // namespace viscoroll::detail
