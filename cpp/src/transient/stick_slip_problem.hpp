/// @file
/// @brief Frictional contact problem at the end of a time step.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "transient/center_motion.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Elastic contact with friction at the end of a time step. A node slips by its displacement relative to the
/// counterbody in this step. Forces are multiplied by the compliance at the end of the step, see
/// docs/theory/transient.md. Arrays contain the nodes row by row.
struct StickSlipProblem {
  const StepOperator& surface;
  Eigen::ArrayXd gap;  ///< without the forces at the end of the step, up to a constant
  /// Slip of the nodes along x and z, without the forces at the end of the step and the displacement of the center.
  Eigen::ArrayX2d known_slip;
  Eigen::ArrayX2d slip_per_center_displacement;  ///< slip due to a unit displacement of the center
  Eigen::ArrayXd weights;                        ///< weights of the nodes, see `half_weights`
  double load;                                   ///< prescribed sum of the normal forces
  double friction;                               ///< coefficient of friction
  /// Condition for the displacement of the center, given the displacements of all parts from `StepOperator::displaced`.
  std::function<CenterRow(const std::vector<HalfField>& displaced)> center_row;
  bool center_row_needs_displacements;  ///< whether the result of `center_row` depends on its argument
};

}  // namespace viscoroll::detail
