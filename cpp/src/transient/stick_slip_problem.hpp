/// @file
/// @brief Problem of stick and slip at one instant of a motion.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "transient/center_motion.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Elastic problem in scaled forces, in which stick and slip refer to the displacement in this step. Arrays
/// contain the nodes row by row.
struct StickSlipProblem {
  const StepOperator& surface;
  Eigen::ArrayXd gap;  ///< without the new forces, up to a constant
  /// Slip of the nodes along x and z, without the new forces and the displacement of the center.
  Eigen::ArrayX2d known_slip;
  Eigen::ArrayX2d by_center;  ///< contribution to the slip per unit displacement of the center
  Eigen::ArrayXd weights;     ///< same as in `half_weights`
  double load;                ///< sum of the normal forces
  double friction;            ///< coefficient
  /// Condition on the center, in scaled forces, for displacements of the parts (`StepOperator::displaced`)
  std::function<CenterRow(const std::vector<HalfField>& displaced)> center;
  bool center_moves;  ///< whether the condition on the center depends on displacements
};

}  // namespace viscoroll::detail
