/// @file
/// @brief Scalar results of a contact at an instant: its size, and the forces and moments about the center.
#pragma once

#include "transient/instant_contact.hpp"

namespace viscoroll::detail {

/// @return area of a flat patch, as used by the half fields [m^2]
[[nodiscard]] double flat_patch(const SurfaceGrid& grid);

/// @brief Set approach, size and pressure of a contact.
/// @param[in] pair both bodies
/// @param[in] instant contact
/// @param[in,out] now instant whose load is set
/// @throws InvalidInput if a coating is compressed by its whole thickness
void set_extent(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now);

/// @brief Forces that do work besides the torque [N].
struct CenterPower {
  double along_track = 0.0;  ///< on the displacement of the center
  /// On the distance by which the center moves farther than the body rolls; the work is dissipated in the counterbody
  /// as its displacement passes
  double creeping = 0.0;
};

/// @brief Set the moments about the center and the force on it. With the vertical compliance, the pressure also does
/// work along the plane, because it displaces the surface in this direction.
/// @param[in] pair both bodies
/// @param[in] instant contact
/// @param[in,out] now instant
/// @return forces that do work besides the torque
[[nodiscard]] CenterPower set_moments(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now);

}  // namespace viscoroll::detail
