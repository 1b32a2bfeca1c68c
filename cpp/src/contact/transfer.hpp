/// @file
/// @brief Transfer of contacts between windows and meshes.
#pragma once

#include <vector>

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief A contact and the problem that it solves.
struct LocatedContact {
  ContactProblem problem;
  ContactSolution contact;

  [[nodiscard]] const Window& window() const { return problem.surface->window(); }
};

/// @brief Return the box around a contact, symmetric in theta, with a margin for nodes that join and for upstream
/// neighbors.
/// @param[in] located contact
/// @param[in] scale spacing of the contact's mesh in spacings of the box, 1 or 2
/// @param[in] limits window that contains the box
[[nodiscard]] Window box_around(const LocatedContact& located, int scale, const Window& limits);

/// @brief Interpolate the forces of a mesh of twice the spacing to the nodes of a window [N].
[[nodiscard]] VectorField prolonged_force(const LocatedContact& coarse, const Window& fine);

/// @brief Interpolate only the pressing forces, as in `prolonged_force`.
[[nodiscard]] Eigen::ArrayXd prolonged_pressing(const LocatedContact& coarse, const Window& fine);

/// @brief Interpolate a state with friction from a mesh of twice the spacing to the window of a problem. Gap and slip
/// give the contacting and sticking nodes more accurately than displacements due to the interpolated forces would.
[[nodiscard]] ContactSolution prolonged(const LocatedContact& coarse, const ContactProblem& fine);

/// @brief Return the nodes of a window in a contact on a mesh of twice the spacing, ascending: those of which at least
/// half of the nearest coarse nodes are in contact.
[[nodiscard]] std::vector<Eigen::Index> prolonged_contact(const LocatedContact& coarse, const Window& fine);

/// @brief Whether the contact, or an upstream neighbor of it, reaches the edge of a window that contains its own.
[[nodiscard]] bool touches_edge(const LocatedContact& located, const Window& window);

/// @brief Extend a contact to the window of a problem that contains its own, with displacements and gaps at all nodes.
[[nodiscard]] ContactSolution extended(const LocatedContact& located, const ContactProblem& whole);

}  // namespace viscoroll::detail
