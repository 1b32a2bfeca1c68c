/// @file
/// @brief Steady stick and slip, whose equations are solved by products with the compliance.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/stick_slip_preconditioner.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief The equations of a problem with friction: nodes slip from their upstream neighbors.
class StickSlipByProducts : public StickSlipSystem {
 public:
  /// @param[in] problem which outlives this object; its drive may change
  explicit StickSlipByProducts(const ContactProblem& problem);

  [[nodiscard]] ConditionScales scales() const override { return scales_; }
  [[nodiscard]] double load() const override { return problem_.normal_force; }
  [[nodiscard]] Eigen::Index first_node() const override { return stride_; }
  [[nodiscard]] double imbalance(const ContactSolution& state) const override;
  void find_displacements(ContactSolution& state) override;
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;
  [[nodiscard]] int products() const override { return products_; }

  /// @return how far the forces of a state are from the drive's condition [N]
  [[nodiscard]] double drive_excess(const ContactSolution& state) const;

  /// @return largest slip of the nodes that stick, per spread of the ways by which strain moves nodes in contact from
  /// their upstream neighbors
  [[nodiscard]] double creep(const ContactSolution& state, const ContactSets& sets) const;

 private:
  const ContactProblem& problem_;
  Eigen::Index stride_;  // from a node to its downstream neighbor
  ConditionScales scales_;
  StickSlipPreconditioner preconditioner_;
  int products_ = 0;
};

}  // namespace viscoroll::detail
