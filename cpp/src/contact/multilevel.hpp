/// @file
/// @brief Contact on fine meshes: started from coarser ones, and solved on the box around the contact.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/transfer.hpp"

namespace viscoroll::detail {

/// @brief Contact, with friction where the problem has some. Small windows are solved as a whole; larger ones in a box
/// around the contact that every other node leads to, and so on: the number of Krylov iterations does not grow with the
/// mesh. Where friction fails on the coarsest level, the next one is started from its own frictionless contact.
/// @param[in] problem on the window of all candidates
/// @param[in] likely_depth nodes whose initial gap is less are taken to touch at first [m]
/// @param[in] options limits
/// @throws ConvergenceError where no state was found
[[nodiscard]] LocatedContact solve_multilevel(const ContactProblem& problem, double likely_depth,
                                              const ContactOptions& options);

/// @brief The same on the whole window of a problem, from a state there.
[[nodiscard]] LocatedContact solve_on_window(const ContactProblem& problem, const ContactSolution& start,
                                             const ContactOptions& options);

}  // namespace viscoroll::detail
