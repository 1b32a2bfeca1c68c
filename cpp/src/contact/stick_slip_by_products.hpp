/// @file
/// @brief Iterative solver for the stick-slip equations of steady rolling.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/stick_slip_preconditioner.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Equations of a problem with friction in which nodes slip relative to their upstream neighbors.
class StickSlipByProducts : public StickSlipSystem {
 public:
  /// @param[in] problem contact problem, which must outlive this object; its drive may change
  explicit StickSlipByProducts(const ContactProblem& problem);

  [[nodiscard]] ConditionScales scales() const override { return scales_; }
  [[nodiscard]] double load() const override { return problem_.normal_force; }
  [[nodiscard]] Eigen::Index first_node() const override { return stride_; }
  [[nodiscard]] double imbalance(const ContactSolution& state) const override;
  void find_displacements(ContactSolution& state) override;
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;
  [[nodiscard]] int products() const override { return products_; }

  /// @return difference of both sides of the drive's condition [N]
  [[nodiscard]] double drive_excess(const ContactSolution& state) const;

  /// @return largest slip of the sticking nodes, relative to the range of the increments of displacement from upstream
  /// neighbors in the contact
  [[nodiscard]] double slip_of_sticking_nodes(const ContactSolution& state, const ContactSets& sets) const;

 private:
  const ContactProblem& problem_;
  Eigen::Index stride_;  // from a node to its downstream neighbor
  ConditionScales scales_;
  StickSlipPreconditioner preconditioner_;
  int products_ = 0;
};

}  // namespace viscoroll::detail
