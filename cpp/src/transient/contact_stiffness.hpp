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
/// keeps its place in the window as the body rolls through: one inverse serves many steps, while the shares of both
/// bodies are nearly the same. Copies share it.
class ContactStiffness {
 public:
  /// @brief Have all nodes of a contact in it, and few beside them.
  /// @param[in] surface of three components
  /// @param[in] contact numbers in a window
  /// @return whether it has changed
  bool cover(const StepOperator& surface, const std::vector<Eigen::Index>& contact);

  /// @return the nodes it has: those of the contact, and such as touched lately
  [[nodiscard]] const std::vector<Eigen::Index>& nodes() const { return inverse_->nodes; }

  /// @return [3 * nodes + component][3 * nodes + component], in the surface's frame [N/m]
  [[nodiscard]] const Eigen::MatrixXd& matrix() const { return inverse_->matrix; }

  void write(NumberWriter& numbers) const;
  /// @param[in] numbers of what another one has written
  /// @param[in] last number that a node may have
  void read(NumberReader& numbers, Eigen::Index last);

 private:
  struct Inverse {
    std::vector<Eigen::Index> nodes;
    Eigen::MatrixXd matrix;
    std::vector<double> shares;  // of the surface when the first of them joined
  };

  /// The inverse with more nodes, by the complement that those before leave of their compliance.
  static Inverse bordered(const Inverse& inverse, const StepOperator& surface, const std::vector<Eigen::Index>& added);

  std::shared_ptr<const Inverse> inverse_;
};

}  // namespace viscoroll::detail
