/// @file
/// @brief Where contact may be, and contacts moved between windows and meshes.
#pragma once

#include <memory>
#include <vector>

#include "contact/coating_compliance.hpp"
#include "contact/contact_solution.hpp"
#include "contact/surface_window.hpp"

namespace viscoroll::detail {

/// @brief Where contact may be, and how the coating there yields.
struct CandidateSurface {
  Formulation formulation;
  SurfaceWindow window;
  std::shared_ptr<const std::vector<Table>> tables;  ///< for `displacement_tables`, reaching across the window
  double swelling;                                   ///< of the free surface by the turning, a factor of lengths
};

/// @brief A contact and the nodes that it was solved on.
struct LocatedContact {
  SurfaceWindow window;
  CoatingCompliance coating;
  ContactSolution contact;
};

/// @return height of every node of a window on the surface above the lowest one, before it is pressed [m]
[[nodiscard]] Eigen::ArrayXd drop(const CandidateSurface& surface, const SurfaceWindow& window);

/// @brief Same surface with every other node: a patch of twice the width lies on a whole patch and half of each of its
/// neighbors, so tables are averages of tables. Patches are flat.
[[nodiscard]] CandidateSurface coarsened(const CandidateSurface& surface);

/// @brief Box around a contact, symmetric in theta, with a margin for nodes to join and for upstream neighbors.
/// @param[in] located contact
/// @param[in] scale its spacings in those of the box, 1 or 2
/// @param[in] limits window that the box stays in
[[nodiscard]] SurfaceWindow box_around(const LocatedContact& located, int scale, const SurfaceWindow& limits);

/// @brief Forces of a mesh of twice the spacing, interpolated on the nodes of a window [N].
[[nodiscard]] VectorField prolonged_force(const LocatedContact& coarse, const SurfaceWindow& fine);

/// @brief Nodes of a window that lie in a contact on a mesh of twice the spacing, ascending: at least half of the
/// nearest coarse nodes are in contact.
[[nodiscard]] std::vector<Eigen::Index> prolonged_contact(const LocatedContact& coarse, const SurfaceWindow& fine);

/// @brief Whether the contact reaches the rim of its window, or its upstream nodes do.
[[nodiscard]] bool touches_edge(const ContactSolution& contact, const WindowShape& shape);

/// @brief The same contact on a window that encloses its own, or is its own, with displacements and gaps everywhere.
/// @param[in] located contact, used up
/// @param[in] surface whose window it is to be on
/// @param[in] execution threads and progress
[[nodiscard]] ContactSolution extended(LocatedContact located, const CandidateSurface& surface,
                                       const Execution& execution);

}  // namespace viscoroll::detail
