/// @file
/// @brief Contacts in which it is given who touches, sticks and slips: what parameters change before nodes join or
/// leave. See docs/theory/sensitivities.md.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief Solve for forces, penetration and creepage.
/// @param[in] problem surface, friction and drive
/// @param[in] kept nodes in contact and those of them that stick; with forces, penetration and creepage of a state near
/// the one that is sought, from which the slipping nodes' directions follow
/// @param[in] options limits
/// @throws ConvergenceError where the equations have no solution near that state
[[nodiscard]] ContactSolution solve_kept_contact(const ContactProblem& problem, ContactSolution kept,
                                                 const ContactOptions& options);

}  // namespace viscoroll::detail
