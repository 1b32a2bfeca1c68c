/// @file
/// @brief What of a contact a history tells at an instant: how large it is, and what forces there do about the center.
#pragma once

#include "transient/touch.hpp"

namespace viscoroll::detail {

/// @return area of a patch that is flat, as those of the half fields are
[[nodiscard]] double flat_patch(const SurfaceGrid& grid);

/// @brief Approach, size and pressure of a contact.
/// @param[in,out] now instant whose load is known
/// @throws std::invalid_argument where a coating is pressed in by its thickness
void tell_extent(const CreepingPair& pair, const Touch& touch, RollingInstant& now);

/// @brief Moments about the center, and the force on it. Pressure works along the plane where it moves what it stands
/// on along it.
/// @param[in,out] now instant
void tell_moments(const CreepingPair& pair, const Touch& touch, RollingInstant& now);

}  // namespace viscoroll::detail
