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

/// @return values at the nodes of a half, row by row, as a column for each row
[[nodiscard]] inline HalfField as_field(const Eigen::ArrayXd& values, Eigen::Index half_nodes) {
  return values.matrix().reshaped(half_nodes, values.size() / half_nodes);
}

/// @param[in] force of the plane on the coating at the nodes of a half, row by row
/// @return the forces of the coating on the plane, by components
[[nodiscard]] HalfField on_plane(const Axes& axes, const VectorField& force);

}  // namespace viscoroll::detail
