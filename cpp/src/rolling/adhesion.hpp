/// @file
/// @brief Adhesion of two bodies: input checks, size of the contact and attraction at the nodes of a mesh. See
/// docs/theory/adhesion.md.
#pragma once

#include <optional>

#include "contact/traction_law.hpp"
#include "rolling/contact_setup.hpp"
#include "rolling/edge_works.hpp"
#include "viscoroll/adhesion.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Reject bodies, friction and drives for which adhesion is not covered.
/// @throws InvalidInput unless the load case has no adhesion or is covered
void require_adhesion(const RollingPair& pair, const LoadCase& load_case);

/// @return relative increase of the torque that adhesion of clean surfaces would cause, or nothing if it is small or
/// unknown; see `Result::clean_adhesion_increase`
/// @param[in] given load case
/// @param[in] result its solution
[[nodiscard]] std::optional<double> clean_adhesion_increase(const RollingCase& given, const Result& result);

/// @return edges across the path, and their laws with cohesive zones of a length [m]
[[nodiscard]] EdgeWorks works_at_edges(const RollingCase& given, double zone);

/// @brief Attraction of two bodies at the nodes of a window.
/// @param[in] given load case with adhesion
/// @param[in] window nodes
[[nodiscard]] Attraction attraction_at(const RollingCase& given, const SurfaceWindow& window);

}  // namespace viscoroll::detail
