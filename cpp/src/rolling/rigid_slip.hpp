/// @file
/// @brief How undeformed bodies slide over one another as they roll.
#pragma once

#include <Eigen/Core>

#include "rolling/drives.hpp"
#include "rolling/rolling_pair.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Ways of what rolls over what it rolls on, from row to row along x and z [m]; 0 in the first row.
struct RigidSlip {
  Eigen::ArrayX2d own;     ///< at no creepage: what turns, whose radius is smaller away from the middle (Heathcote)
  Eigen::ArrayX2d guided;  ///< what a guide adds: lateral creepage, and spin about the vertical axis
};

/// @param[in] points where displacements are taken
/// @param[in] swelling of the free surface, by the turning
/// @param[in] kinematics with Heathcote slip or without
/// @param[in] pair both bodies
/// @param[in] given lateral creepage and spin
[[nodiscard]] RigidSlip rigid_slip(const SurfaceWindow& points, double swelling, SlipKinematics kinematics,
                                   const RollingPair& pair, const GivenMotion& given);

}  // namespace viscoroll::detail
