/// @file
/// @brief Solution of the contact in a window that contains it; the search starts with a likely window and widens it.
#pragma once

#include <optional>

#include "contact/contact_solution.hpp"
#include "rolling/assembly.hpp"

namespace viscoroll::detail {

/// @brief A contact in a window that contains it.
struct HeldContact {
  SurfaceWindow nodes;
  ContactProblem problem;
  ContactSolution contact;
  Losses losses;
};

/// @brief Solve in windows, each half as wide again as the one before, until one contains the contact.
/// @param[in] assembly the load case
/// @param[in] seen extent of the contact on a coarser mesh, if there was one
/// @throws std::invalid_argument for loads whose contact no window contains
/// @throws ConvergenceError if no contact was found
/// @throws MeshTooFine if the mesh needs too many nodes
[[nodiscard]] HeldContact find_held_contact(const Assembly& assembly, const std::optional<ContactReach>& seen);

}  // namespace viscoroll::detail
