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

/// @brief Edges of the surfaces across the path, far from each other.
struct EdgeReleases {
  double opening;       ///< energy release rate by the relaxed compliance, G_open [J/m^2]
  double closing;       ///< energy release rate by the relaxed compliance, G_close [J/m^2]
  double shorter_zone;  ///< length of the shorter cohesive zone; 0 with an infinite strength [m]
};

/// @return edges across the path at the speed of rolling
[[nodiscard]] EdgeReleases releases_at_edges(const RollingCase& given);

/// @return largest distance between neighboring nodes [m]
[[nodiscard]] double node_spacing(const SurfaceGrid& grid, bool is_line);

/// @brief Length of the cohesive zones of a mesh, which must be short, since their laws are those of the edge of a
/// half-plane.
/// @param[in] given load case with adhesion
/// @param[in] result its solution
/// @return length relative to the half-width of the contact, or to the thickness of the outermost layers if that is
/// smaller; 0 if the mesh resolves the zones of the surfaces
[[nodiscard]] double relative_zone(const RollingCase& given, const Result& result);

/// @brief Attraction of two bodies at the nodes of a window.
/// @param[in] given load case with adhesion
/// @param[in] window nodes
[[nodiscard]] Attraction attraction_at(const RollingCase& given, const SurfaceWindow& window);

}  // namespace viscoroll::detail
