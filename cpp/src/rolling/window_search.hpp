/// @file
/// @brief Search for a window that contains the whole contact, and solution of the contact in this window.
#pragma once

#include <optional>

#include "contact/contact_solution.hpp"
#include "rolling/contact_setup.hpp"

namespace viscoroll::detail {

/// @brief Solved contact in a window of nodes that contains the whole contact.
struct WindowContact {
  SurfaceWindow nodes;      ///< nodes of the window
  ContactProblem problem;   ///< contact problem on these nodes
  ContactSolution contact;  ///< its solution
  Losses losses;            ///< dissipation of the solution
};

/// @brief Solve the contact in a window around its expected extent. While the contact reaches the edge of the window,
/// widen the window by half and solve again.
/// @param[in] setup the load case
/// @param[in] coarse_contact extent of the contact on a coarser mesh, if there is a result on one; otherwise the extent
/// is estimated
/// @throws InvalidInput if the load is so large that the contact exceeds the widest window
/// @throws ConvergenceError if the contact iteration does not converge
/// @throws MeshTooFine if a window has too many nodes
[[nodiscard]] WindowContact find_contact_in_window(const ContactSetup& setup,
                                                   const std::optional<ContactReach>& coarse_contact);

}  // namespace viscoroll::detail
