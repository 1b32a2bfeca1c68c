/// @file
/// @brief Forces and displacements of the nodes in the frame of the plane.
#pragma once

#include <array>

#include "surface/surface_operator.hpp"
#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief Directions of the plane's frame, by `Axis`: forward, down and sideways, each by its components r, phi and
/// theta at the nodes.
using Axes = std::array<std::array<HalfField, 3>, 3>;

/// @return component of a vector field along a direction
[[nodiscard]] HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field);
/// @return vector field with a given component along a direction
[[nodiscard]] HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar);

/// @return values at the nodes of a half field, given row by row, with one column for each row
[[nodiscard]] inline HalfField as_field(const Eigen::ArrayXd& values, Eigen::Index half_nodes) {
  return values.matrix().reshaped(half_nodes, values.size() / half_nodes);
}

/// @param[in] axes directions at the nodes
/// @param[in] force of the plane on the coating at the nodes of a half field, row by row
/// @return the forces of the coating on the plane, by components
[[nodiscard]] HalfField on_plane(const Axes& axes, const VectorField& force);

}  // namespace viscoroll::detail
