/// @file
/// @brief Contact on fine meshes: started from coarser ones and solved on a box around the contact.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/transfer.hpp"

namespace viscoroll::detail {

/// @return whether the window has enough nodes in both directions for a start from every other node to save time
[[nodiscard]] bool is_worth_coarsening(const Window& window);

/// @brief Solve a contact with or without friction or adhesion.
/// Small windows and periodic surfaces are solved as a whole. On a larger window the solver first solves the mesh of
/// every other node, recursively, and then a box around that contact, so that the number of Krylov iterations does not
/// grow with the mesh. If friction fails on the coarsest level, the next level starts from its own frictionless
/// contact.
/// @param[in] problem problem on the window of all candidate nodes
/// @param[in] contact_gap_limit undeformed gap below which nodes are assumed to be in contact at first [m]
/// @param[in] options limits
/// @throws ConvergenceError if no state was found
[[nodiscard]] LocatedContact solve_multilevel(const ContactProblem& problem, double contact_gap_limit,
                                              const ContactOptions& options);

/// @brief Solve a contact on the whole window of the problem, from a state on that window.
[[nodiscard]] LocatedContact solve_on_window(const ContactProblem& problem, const ContactSolution& start,
                                             const ContactOptions& options);

}  // namespace viscoroll::detail
