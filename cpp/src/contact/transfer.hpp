/// @file
/// @brief Contacts moved between windows and meshes.
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

/// @brief Box around a contact, symmetric in theta, with a margin for nodes to join and for upstream neighbors.
/// @param[in] located contact
/// @param[in] scale its spacings in those of the box, 1 or 2
/// @param[in] limits window that the box stays in
[[nodiscard]] Window box_around(const LocatedContact& located, int scale, const Window& limits);

/// @brief Forces of a mesh of twice the spacing, interpolated on the nodes of a window [N].
[[nodiscard]] VectorField prolonged_force(const LocatedContact& coarse, const Window& fine);

/// @brief Those that press alone.
[[nodiscard]] Eigen::ArrayXd prolonged_pressing(const LocatedContact& coarse, const Window& fine);

/// @brief State with friction of a mesh of twice the spacing, on the window of a problem: forces, gap and slip, from
/// which it is known who touches and who sticks. Displacements by the forces are rougher.
[[nodiscard]] ContactSolution prolonged(const LocatedContact& coarse, const ContactProblem& fine);

/// @brief Nodes of a window that lie in a contact on a mesh of twice the spacing, ascending: at least half of the
/// nearest coarse nodes are in contact.
[[nodiscard]] std::vector<Eigen::Index> prolonged_contact(const LocatedContact& coarse, const Window& fine);

/// @brief Whether the contact reaches the rim of a window that encloses its own, or its upstream nodes do.
[[nodiscard]] bool touches_edge(const LocatedContact& located, const Window& window);

/// @brief The same contact on the window of a problem that encloses its own, with displacements and gaps everywhere.
[[nodiscard]] ContactSolution extended(const LocatedContact& located, const ContactProblem& whole);

}  // namespace viscoroll::detail
