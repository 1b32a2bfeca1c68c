/// @file
/// @brief How undeformed bodies slide over one another as they roll.
#pragma once

#include <Eigen/Core>

#include "rolling/drives.hpp"
#include "rolling/mesh_model.hpp"
#include "rolling/rolling_pair.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Ways from row to row along x and z [m]; 0 in the first row.
struct RigidWays {
  /// Of what rolls over what it rolls on at no creepage of a drive: radii are smaller away from the middle (Heathcote),
  /// and a guide adds lateral creepage, and spin about the vertical axis
  Eigen::ArrayX2d slip;
  Eigen::ArrayX2d counterpart_way;  ///< of the surface of what it rolls on, at no creepage
};

/// @param[in] points where displacements are taken
/// @param[in] swelling of the free surfaces, by the turning
/// @param[in] kinematics with Heathcote slip or without
/// @param[in] pair both bodies
/// @param[in] given lateral creepage and spin
[[nodiscard]] RigidWays rigid_slip(const SurfaceWindow& points, const Swelling& swelling, SlipKinematics kinematics,
                                   const RollingPair& pair, const GivenMotion& given);

}  // namespace viscoroll::detail
