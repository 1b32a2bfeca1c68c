/// @file
/// @brief Frictionless contact at an instant: an elastic problem with a symmetric table, see docs/theory/transient.md.
#pragma once

#include <Eigen/Core>

#include "contact/active_set.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Minimize p K p / 2 + gap p over normal forces p >= 0 with a given sum.
struct ElasticContactProblem {
  const StepOperator& surface;
  HalfField gap;      ///< without these forces, up to a constant
  HalfField weights;  ///< same as in `half_weights`, at every node
  double load;        ///< sum of all forces
};

/// @brief Solve by an active set, with conjugate gradients among the nodes in contact in the space of forces with the
/// given sum.
/// @param[in] problem gap and load
/// @param[in] guess normal forces to start from, row by row, at least one of them positive
/// @param[in,out] inverse of an earlier contact
/// @throws ConvergenceError if the contact does not settle
[[nodiscard]] PressedNodes solve_elastic_contact(const ElasticContactProblem& problem, const Eigen::ArrayXd& guess,
                                                 ContactInverse& inverse);

}  // namespace viscoroll::detail
