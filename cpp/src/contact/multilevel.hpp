/// @file
/// @brief Normal contact on fine meshes: started from coarser ones, and solved on the box around the contact.
#pragma once

#include <memory>
#include <vector>

#include "contact/coating_compliance.hpp"
#include "contact/contact_solution.hpp"
#include "contact/normal_contact.hpp"
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

/// @brief Same surface with every other node: a patch of twice the width lies on a whole patch and half of each of its
/// neighbors, so tables are averages of tables.
[[nodiscard]] CandidateSurface coarsened(const CandidateSurface& surface);

/// @brief Frictionless contact. Small windows are solved as a whole; larger ones in a box around the contact that every
/// other node leads to, and so on: the number of Krylov iterations does not grow with the mesh.
/// @param[in] surface candidates
/// @param[in] load [N], > 0
/// @param[in] estimate radius of the contact [m], from above
/// @param[in] options limits
/// @param[in] execution threads and progress
[[nodiscard]] LocatedContact solve_multilevel(const CandidateSurface& surface, double load, double estimate,
                                              const ContactOptions& options, const Execution& execution);

/// @brief The same without friction on the whole window, from a state there.
[[nodiscard]] LocatedContact solve_on_window(const LocatedContact& start, const CandidateSurface& surface, double load,
                                             const ContactOptions& options);

/// @brief Whether the contact reaches the rim of its window, or its upstream nodes do.
[[nodiscard]] bool touches_edge(const ContactSolution& contact, const WindowShape& shape);

/// @brief The same contact on a window that encloses its own, or is its own, with displacements and gaps everywhere.
/// @param[in] located contact, used up
/// @param[in] surface gives the window
/// @param[in] execution threads and progress
[[nodiscard]] LocatedContact extended(LocatedContact located, const CandidateSurface& surface,
                                      const Execution& execution);

}  // namespace viscoroll::detail
