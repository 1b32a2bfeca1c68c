/// @file
/// @brief One instant of a frictionless contact: an elastic problem with a symmetric table,
/// See docs/theory/transient.md.
#pragma once

#include <Eigen/Core>

#include "contact/active_set.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Minimize p K p / 2 + gap p over the pressing forces p >= 0 of a given sum.
struct ElasticContactProblem {
  const StepOperator& surface;
  HalfField gap;      ///< without these forces, up to a constant
  HalfField weights;  ///< of `half_weights`, at every node
  double load;        ///< sum of all forces
};

/// @brief Active set with conjugate gradients among the nodes in contact, in the space of forces of the given sum.
/// @param[in] problem gap and load
/// @param[in] guess pressing forces to start from, row by row, one of them above zero
/// @param[in,out] inverse of an earlier contact
/// @throws ConvergenceError where the contact does not settle
[[nodiscard]] PressedNodes solve_elastic_contact(const ElasticContactProblem& problem, const Eigen::ArrayXd& guess,
                                                 ContactInverse& inverse);

}  // namespace viscoroll::detail
