/// @file
/// @brief Slip between undeformed bodies in rolling.
#pragma once

#include <Eigen/Core>

#include "rolling/drives.hpp"
#include "rolling/mesh_model.hpp"
#include "rolling/rolling_pair.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Displacements from row to row along x and z [m]; 0 in the first row.
struct RigidDisplacements {
  /// Slip of the rolling body over the counterbody at zero creepage of the drive: radii are smaller away from the
  /// middle (Heathcote slip), and the drive may prescribe lateral creepage and spin about the vertical axis
  Eigen::ArrayX2d slip;
  Eigen::ArrayX2d counterbody;  ///< displacement of the counterbody's surface at zero creepage
};

/// @brief Slip and displacement of undeformed bodies from row to row.
/// @param[in] points positions at which displacements are evaluated
/// @param[in] growth centrifugal growth of the free surfaces
/// @param[in] kinematics with or without Heathcote slip
/// @param[in] pair both bodies
/// @param[in] given lateral creepage and spin
[[nodiscard]] RigidDisplacements rigid_slip(const SurfaceWindow& points, const CentrifugalGrowth& growth,
                                            SlipKinematics kinematics, const RollingPair& pair,
                                            const GivenMotion& given);

}  // namespace viscoroll::detail
