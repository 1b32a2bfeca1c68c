/// @file
/// @brief Forces of a contact without friction by its displacements, from earlier contacts of nearly the same nodes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "transient/numbers.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief The inverse of the compliance between the nodes that touch or did lately, which a contact that keeps its
/// place in the window hardly changes. Nodes that join border it, and those of it that are apart bear no force by the
/// forces that undo theirs: of the compliance that it was made of it is exact. Copies share it.
class ContactInverse {
 public:
  /// @brief Have all nodes of a contact in it, and few beside them.
  /// @param[in] surface whose compliance it is
  /// @param[in] contact numbers in a window, ascending
  void follow(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  /// @return forces on the nodes of the last `follow` by displacements there
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& displacement) const;

  /// @brief Be made anew next time: of another compliance.
  void forget() { inverse_.reset(); }

  void write(NumberWriter& numbers) const;
  /// @param[in] numbers of what another one has written
  /// @param[in] last number that a node may have
  void read(NumberReader& numbers, Eigen::Index last);

 private:
  struct Inverse {
    std::vector<Eigen::Index> nodes;
    Eigen::MatrixXd matrix;
  };

  void cover(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  std::shared_ptr<const Inverse> inverse_;
  std::vector<Eigen::Index> touching_;  // places in the inverse of each node
  std::vector<Eigen::Index> apart_;     // places of the others
  Eigen::MatrixXd lower_;               // factor, of Cholesky, of these others' own rows
};

}  // namespace viscoroll::detail
