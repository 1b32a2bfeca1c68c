/// @file
/// @brief One instant of a frictionless contact: an elastic problem with a symmetric table, docs/theory.md section
/// 13.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact/active_set.hpp"
#include "transient/numbers.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Approximate inverse of the compliance between the nodes of a contact, from an earlier contact of nearly the
/// same nodes. Copies share it.
class ContactInverse {
 public:
  /// @brief Make it anew unless the contact has hardly changed.
  /// @param[in] nodes in contact: numbers in a window, ascending
  /// @param[in] compliance between them, its lower half
  void follow(const std::vector<Eigen::Index>& nodes, const Eigen::MatrixXd& compliance);

  /// @return approximate forces on the nodes of the last `follow` by displacements there
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& displacement) const;

  void write(NumberWriter& numbers) const;
  /// @param[in] numbers of what another one has written
  /// @param[in] last number that a node may have
  void read(NumberReader& numbers, Eigen::Index last);

 private:
  struct Factor {
    std::vector<Eigen::Index> nodes;
    Eigen::MatrixXd lower;  // of Cholesky
    double own_compliance;
  };

  std::shared_ptr<const Factor> factor_;
  std::vector<Eigen::Index> places_;  // in the factor of each node, or -1
};

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
