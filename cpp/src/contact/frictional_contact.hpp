/// @file
/// @brief Steady rolling contact with Coulomb friction: who touches, who sticks, and how fast what rolls moves.
/// See docs/theory/friction.md.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief How a state is reached: Newton steps (`SemismoothNewton`) from a coarser mesh, from full stick or from no
/// friction, and where they fail by way of given creepages or of another friction.
/// @param[in] problem surface, initial gap, normal force, friction, which may be infinite, and drive
/// @param[in] start frictionless solution, or one with friction and its creepage
/// @param[in] options limits; `max_iterations` is for all linear systems
/// @return a converged state, whose residual is the norm of all violated conditions, in forces, per normal force
/// @throws ConvergenceError where none was found
[[nodiscard]] ContactSolution solve_frictional_contact(const ContactProblem& problem, const ContactSolution& start,
                                                       const ContactOptions& options);

}  // namespace viscoroll::detail
