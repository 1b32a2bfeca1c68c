/// @file
/// @brief Solving the contact, in a window that holds it: from a likely one on to wider ones.
#pragma once

#include <optional>

#include "contact/contact_solution.hpp"
#include "rolling/assembly.hpp"

namespace viscoroll::detail {

/// @brief A contact in a window that holds it.
struct HeldContact {
  SurfaceWindow nodes;
  ContactProblem problem;
  ContactSolution contact;
  Losses losses;
};

/// @brief Solve in windows, each half as wide again as the one before, until one holds the contact.
/// @param[in] assembly the load case
/// @param[in] seen reach of the contact on a coarser mesh, where there was one
/// @throws std::invalid_argument for loads under which no window does
/// @throws ConvergenceError where no contact was found
/// @throws MeshTooFine where the mesh needs too many nodes
[[nodiscard]] HeldContact find_held_contact(const Assembly& assembly, const std::optional<ContactReach>& seen);

}  // namespace viscoroll::detail
