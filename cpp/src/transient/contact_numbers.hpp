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

/// @brief Forces that work along ways [N].
struct CenterPower {
  double along_track = 0.0;  ///< of the center
  /// By what the center goes farther than it rolls: what the counterpart loses as its displacement passes.
  double creeping = 0.0;
};

/// @brief Moments about the center, and the force on it. Pressure works along the plane where it moves what it stands
/// on along it.
/// @param[in,out] now instant
/// @return what works beside the torque
[[nodiscard]] CenterPower tell_moments(const CreepingPair& pair, const Touch& touch, RollingInstant& now);

}  // namespace viscoroll::detail
