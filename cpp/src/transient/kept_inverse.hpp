/// @file
/// @brief The inverse of the compliance between the nodes of a contact, kept from step to step.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "transient/numbers.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Forces on some nodes of a window by their displacements. Compliance knows differences alone, and a contact
/// keeps its place in the window as the body rolls through: one inverse serves many steps. Nodes that join border it.
/// Copies share it.
class KeptInverse {
 public:
  /// @return [components * displaced + component][components * loaded + component]; of nodes by themselves, where both
  /// are the same, with an inverse
  using Compliance = Eigen::MatrixXd (*)(const StepOperator& surface, const std::vector<Eigen::Index>& displaced,
                                         const std::vector<Eigen::Index>& loaded);

  /// @param[in] components of a node
  /// @param[in] compliance between two sets of nodes
  /// @param[in] most_change of a surface's shares, relative, with which an inverse is kept
  KeptInverse(Eigen::Index components, Compliance compliance, double most_change)
      : components_(components), compliance_(compliance), most_change_(most_change) {}

  /// @brief Have all nodes of a contact in it, and few beside them.
  /// @param[in] surface of the parts that the inverse was begun with; it stays one by the shares of then
  /// @param[in] contact numbers in a window, ascending
  /// @return whether it has changed
  bool cover(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  /// @brief Be made anew next time: of another compliance.
  void forget() { inverse_.reset(); }

  /// @return the nodes it has: those of the contact, and such as touched lately
  [[nodiscard]] const std::vector<Eigen::Index>& nodes() const { return inverse_->nodes; }

  /// @return as `Compliance` has its rows and columns [N/m]
  [[nodiscard]] const Eigen::MatrixXd& matrix() const { return inverse_->matrix; }

  /// @return of the surface that it is of
  [[nodiscard]] const std::vector<double>& shares() const { return inverse_->shares; }

  void write(NumberWriter& numbers) const;
  /// @param[in] numbers of what another one has written
  /// @param[in] last number that a node may have
  void read(NumberReader& numbers, Eigen::Index last);

 private:
  struct Inverse {
    std::vector<Eigen::Index> nodes;
    Eigen::MatrixXd matrix;
    std::vector<double> shares;
  };

  Eigen::Index components_;
  Compliance compliance_;
  double most_change_;
  std::shared_ptr<const Inverse> inverse_;
};

}  // namespace viscoroll::detail
