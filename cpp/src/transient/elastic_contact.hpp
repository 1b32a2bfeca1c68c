/// @file
/// @brief Frictionless contact at an instant: an elastic problem with a symmetric table, see docs/theory/transient.md.
#pragma once

#include <Eigen/Core>

#include "contact/active_set.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Condition for the normal forces and the penetration: force * (sum of the forces) + penetration * (penetration
/// - coasted) = value. It prescribes the load, the penetration, or the motion of an axle with mass.
struct ApproachCondition {
  double force = 1.0;
  double penetration = 0.0;
  double value;
  /// Penetration without forces [m]. In a short step, the contact changes the motion of a heavy axle by less than its
  /// round-off.
  double coasted = 0.0;
};

/// @brief Minimize p K p / 2 + gap p over normal forces p >= 0 under the condition.
struct ElasticContactProblem {
  const StepOperator& surface;
  HalfField gap;      ///< without these forces; up to a constant if the sum of the forces is given
  HalfField weights;  ///< same as in `half_weights`, at every node
  ApproachCondition condition;
};

/// @brief Solve by an active set, with conjugate gradients among the nodes in contact in the space of forces that
/// fulfill the condition.
/// @param[in] problem gap and condition; at least one node is in contact
/// @param[in] guess normal forces to start from, row by row, at least one of them positive
/// @param[in,out] inverse of an earlier contact
/// @throws ConvergenceError if the contact does not settle
[[nodiscard]] PressedNodes solve_elastic_contact(const ElasticContactProblem& problem, const Eigen::ArrayXd& guess,
                                                 ContactInverse& inverse);

}  // namespace viscoroll::detail
