/// @file
/// @brief Two bodies that roll on one another, and what both together are.
#pragma once

#include <vector>

#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @brief What rolls, and what it rolls on.
struct RollingPair {
  Body body;
  Body on;
};

/// @throws std::invalid_argument naming parameter, value, unit and range, where a body is none or the two cannot roll
/// on one another
[[nodiscard]] RollingPair rolling_pair(const RollingBody& body, const Counterpart& on);

/// @return R of 1/R = 1/R_1 + 1/R_2 along the path [m]
[[nodiscard]] double relative_radius(const RollingPair& pair);

/// @return across, within which they touch; infinite where neither has sides [m]
[[nodiscard]] double width(const RollingPair& pair);

/// @return all layers of both, those of the body first
[[nodiscard]] std::vector<NamedLayer> layers(const RollingPair& pair);

/// @return thickness of all of them together [m], maybe infinite
[[nodiscard]] double thickness(const RollingPair& pair);

/// @return the same without half-spaces [m]
[[nodiscard]] double layer_thickness(const RollingPair& pair);

/// @return how soft a half-space is, beside the softest layer, at rest: from 0, rigid or none, to 1
[[nodiscard]] double half_space_share(const RollingPair& pair);

}  // namespace viscoroll::detail
