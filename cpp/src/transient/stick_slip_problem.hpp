/// @file
/// @brief Stick and slip at one instant of a motion, before anything is solved.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "transient/center_motion.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief An elastic problem in scaled forces, whose stick and slip belong to the way of this step. Arrays have the
/// nodes row by row.
struct StickSlipProblem {
  const StepOperator& surface;
  Eigen::ArrayXd gap;   ///< without these forces, up to a constant
  Eigen::ArrayX2d way;  ///< of the nodes along x and z over what they touch, without these forces and the center's
  Eigen::ArrayX2d by_center;  ///< what the way of the center adds to it, for a unit
  Eigen::ArrayXd weights;     ///< of `half_weights`
  double load;                ///< sum of the pressing forces
  double friction;            ///< coefficient
  /// What holds for the center, in scaled forces, by what these displace (`StepOperator::displaced`)
  std::function<CenterRow(const std::vector<HalfField>& displaced)> center;
  bool center_moves;  ///< whether that depends on displacements
};

}  // namespace viscoroll::detail
