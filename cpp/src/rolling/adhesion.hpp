/// @file
/// @brief Adhesion of two bodies: input checks, size of the contact and attraction at the nodes of a mesh. See
/// docs/theory/adhesion.md.
#pragma once

#include "contact/traction_law.hpp"
#include "rolling/contact_setup.hpp"
#include "rolling/edge_works.hpp"
#include "viscoroll/adhesion.hpp"

namespace viscoroll::detail {

/// @brief Reject bodies, friction and drives for which adhesion is not covered.
/// @throws InvalidInput unless the load case has no adhesion or is covered
void require_adhesion(const RollingPair& pair, const LoadCase& load_case);

/// @return works and cohesive zones of edges across the path, for a law with a peak [Pa]
[[nodiscard]] EdgeWorks works_at_edges(const RollingCase& given, double peak);

/// @brief Attraction of two bodies at the nodes of a window.
/// @param[in] given load case with adhesion
/// @param[in] window nodes
[[nodiscard]] Attraction attraction_at(const RollingCase& given, const SurfaceWindow& window);

}  // namespace viscoroll::detail
