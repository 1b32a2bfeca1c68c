/// @file
/// @brief Frozen contact: the solution for given contacting, sticking and slipping nodes, as parameters change by so
/// little that no node changes its state. See docs/theory/sensitivities.md.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief Solve a frozen contact for forces, penetration and creepage.
/// @param[in] problem surface, friction and drive
/// @param[in] kept nodes in contact and the sticking ones among them, with forces, penetration and creepage of a nearby
/// state, from which the directions of slip follow
/// @param[in] options limits
/// @throws ConvergenceError if the equations have no solution near that state
[[nodiscard]] ContactSolution solve_frozen_contact(const ContactProblem& problem, ContactSolution kept,
                                                   const ContactOptions& options);

}  // namespace viscoroll::detail
