/// @file
/// @brief Contact forces from displacements, by an inverse kept from earlier contacts of nearly the same nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/dense_solvers.hpp"
#include "transient/kept_inverse.hpp"

namespace viscoroll::detail {

/// @brief Stiffness for forces in three directions, from the inverse of a surface that has hardly changed; Newton steps
/// correct the difference.
class ContactStiffness : public KeptInverse {
 public:
  ContactStiffness();
};

/// @brief Stiffness for normal forces on the nodes of a contact. Nodes of the inverse that have separated are given
/// zero force by correction forces. The result is exact for the compliance of the inverse and for multiples of it.
class ContactInverse : public KeptInverse {
 public:
  ContactInverse();

  /// @brief Include the nodes of a contact, and find the nodes of the inverse that have separated.
  /// @param[in] surface provides the compliance
  /// @param[in] contact numbers of the nodes in a window, ascending
  void follow(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  /// @return normal forces on the nodes of the last `follow` for displacements of these nodes
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& displacement) const;

 private:
  std::vector<Eigen::Index> touching_;  // positions of the contact nodes in the inverse
  std::vector<Eigen::Index> apart_;     // positions of the separated nodes in the inverse
  double scale_ = 1.0;                  // factor on the inverse
  DenseFactors reactions_;              // factors of the rows of the separated nodes
};

}  // namespace viscoroll::detail
