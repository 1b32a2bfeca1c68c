/// @file
/// @brief Steady rolling contact with Coulomb friction: contact, stick, slip and creepage. See docs/theory/friction.md.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief Solve a contact with friction by semismooth Newton steps (`SemismoothNewton`).
/// Starting points are a coarser mesh, full stick and the frictionless contact; if all of them fail, states at given
/// creepages or at another coefficient of friction.
/// @param[in] problem surface, initial gap, load, friction (the coefficient may be infinite) and drive
/// @param[in] start frictionless solution, or a state with friction and its creepage
/// @param[in] options limits; `max_iterations` counts all linear systems
/// @return converged state, whose residual is the norm of all violated conditions, as forces, per load
/// @throws ConvergenceError if no state was found
[[nodiscard]] ContactSolution solve_frictional_contact(const ContactProblem& problem, const ContactSolution& start,
                                                       const ContactOptions& options);

}  // namespace viscoroll::detail
