/// @file
/// @brief Forces of a contact by its displacements, from earlier contacts of nearly the same nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dense_solvers.hpp"
#include "transient/kept_inverse.hpp"

namespace viscoroll::detail {

/// @brief Forces in three directions, by the inverse of a surface that has hardly changed: what is left, steps correct.
class ContactStiffness : public KeptInverse {
 public:
  ContactStiffness();
};

/// @brief Pressing forces on the nodes of a contact alone: those that are in the inverse and apart bear none by the
/// forces that undo theirs. Of the compliance that the inverse is of, or a multiple of it, it is exact.
class ContactInverse : public KeptInverse {
 public:
  ContactInverse();

  /// @brief Cover the nodes of a contact, and note which of the inverse's are apart.
  /// @param[in] surface whose compliance it is
  /// @param[in] contact numbers in a window, ascending
  void follow(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  /// @return forces on the nodes of the last `follow` by displacements there
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& displacement) const;

 private:
  std::vector<Eigen::Index> touching_;  // places in the inverse of each node
  std::vector<Eigen::Index> apart_;     // places of the others
  double scale_ = 1.0;                  // of the inverse
  DenseFactors reactions_;              // of these others' own rows
};

}  // namespace viscoroll::detail
