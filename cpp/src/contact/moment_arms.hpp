/// @file
/// @brief Moment of contact forces about the center of rotation.
#pragma once

#include <Eigen/Core>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Moment arms of contact forces, from the center of rotation [m].
struct MomentArms {
  Eigen::ArrayXd x;  ///< forward
  Eigen::ArrayXd y;  ///< down
  double radius;     ///< radius of the undeformed rotating body
  /// Slope of the undeformed surface of the counterbody, positive where it falls in the direction in which the material
  /// moves; no rows if there is no slope
  Eigen::ArrayXd slope = {};
};

/// @brief Change of moment arms by displacements.
/// @param[in] displacement displacement of every node [m]
/// @param[in] pressure_work_factor factor on the change along x: 0 if pressure does no work along the plane, else 1
[[nodiscard]] MomentArms added_arms(const VectorField& displacement, double pressure_work_factor);

/// @return moment arms of displaced points; parameters same as in `added_arms`
[[nodiscard]] MomentArms displaced(MomentArms arms, const VectorField& displacement, double pressure_work_factor);

/// @return moment y F_x - x F_y per unit of each force component [m]
[[nodiscard]] VectorField moment_per_force(const MomentArms& arms);

/// @return moment of all forces [N m]
[[nodiscard]] double moment(const MomentArms& arms, const VectorField& force);

}  // namespace viscoroll::detail
