/// @file
/// @brief Forces and displacements of the coating's nodes in the frame of the plane.
#pragma once

#include <array>

#include "surface/surface_operator.hpp"
#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief Directions in the plane's frame, by `Axis`: forward, down, sideways, each by its components r, phi, theta at
/// the nodes.
using Axes = std::array<std::array<HalfField, 3>, 3>;

/// @return a component of a vector field along a direction
[[nodiscard]] HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field);
/// @return the vector field of that component along a direction
[[nodiscard]] HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar);

/// @brief Tractions of the plane on the coating, as nodal forces of a half: pressing, and along the plane.
struct PlaneForces {
  HalfField pressing;
  HalfField forward;
  HalfField sideways;
};

/// @return the forces of the body on the plane, by components
[[nodiscard]] HalfField on_plane(const Axes& axes, const PlaneForces& forces);

}  // namespace viscoroll::detail
