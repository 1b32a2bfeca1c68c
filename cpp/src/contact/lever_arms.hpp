/// @file
/// @brief The moment of contact forces about the center of rotation.
#pragma once

#include <Eigen/Core>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Where forces act, from the center of rotation [m].
struct LeverArms {
  Eigen::ArrayXd x;  ///< forward
  Eigen::ArrayXd y;  ///< down
  double radius;     ///< of the undeformed body that turns
  /// Of the undeformed surface that it rolls on, downwards along the way of the material; no rows where it has none
  Eigen::ArrayXd slope = {};
};

/// @brief What displacements add to lever arms.
/// @param[in] displacement of every node [m]
/// @param[in] pressure_share of the arm along x: 0 where pressure does no work along the plane, else 1
[[nodiscard]] LeverArms added_arms(const VectorField& displacement, double pressure_share);

/// @return arms of displaced points; the parameters as for `added_arms`
[[nodiscard]] LeverArms displaced(LeverArms arms, const VectorField& displacement, double pressure_share);

/// @return moment y F_x - x F_y of a unit of each force [m]
[[nodiscard]] VectorField moment_per_force(const LeverArms& arms);

/// @return moment of forces [N], their sum [N m]
[[nodiscard]] double moment(const LeverArms& arms, const VectorField& force);

}  // namespace viscoroll::detail
