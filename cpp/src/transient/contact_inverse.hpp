/// @file
/// @brief Contact forces from displacements, by an inverse of the compliance that is kept from step to step, because
/// successive contacts have nearly the same nodes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "base/dense_solvers.hpp"
#include "transient/numbers.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Stiffness between some nodes of a window. The compliance depends only on offsets between nodes, and a contact
/// stays in place in the window while the body rolls, so that one inverse serves many steps. Nodes that join are added
/// by bordering. Copies share the inverse.
class KeptInverse {
 public:
  /// @return compliance matrix [components * displaced + component][components * loaded + component]; invertible if
  /// both sets of nodes are equal
  using Compliance = Eigen::MatrixXd (*)(const StepOperator& surface, const std::vector<Eigen::Index>& displaced,
                                         const std::vector<Eigen::Index>& loaded);

  /// @param[in] components unknowns of a node
  /// @param[in] compliance between two sets of nodes
  /// @param[in] max_change largest relative change of the surface's shares for which an inverse is kept
  KeptInverse(Eigen::Index components, Compliance compliance, double max_change)
      : components_(components), compliance_(compliance), max_change_(max_change) {}

  /// @brief Include all nodes of a contact, and few others.
  /// @param[in] surface surface of the same parts as before; the inverse keeps the shares with which it was begun
  /// @param[in] contact numbers of the nodes in a window, ascending
  /// @return whether the inverse has changed
  bool cover(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  /// @brief Discard the inverse, because the compliance has changed.
  void forget() { inverse_.reset(); }

  /// @return nodes of the inverse: those of the contact, and others that were recently in contact
  [[nodiscard]] const std::vector<Eigen::Index>& nodes() const { return inverse_->nodes; }

  /// @return inverse, with rows and columns as in `Compliance` [N/m]
  [[nodiscard]] const Eigen::MatrixXd& matrix() const { return inverse_->matrix; }

  /// @return shares of the surface to which the inverse belongs
  [[nodiscard]] const std::vector<double>& shares() const { return inverse_->shares; }

  void write(NumberWriter& numbers) const;
  /// @param[in] numbers data written by another object
  /// @param[in] last largest valid number of a node
  void read(NumberReader& numbers, Eigen::Index last);

 private:
  struct Inverse {
    std::vector<Eigen::Index> nodes;
    Eigen::MatrixXd matrix;
    std::vector<double> shares;
  };

  Eigen::Index components_;
  Compliance compliance_;
  double max_change_;
  std::shared_ptr<const Inverse> inverse_;
};

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
