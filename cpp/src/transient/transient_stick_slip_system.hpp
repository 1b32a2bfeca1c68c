/// @file
/// @brief Stick and slip between body and counterbody: nodes slip from their own positions in the previous step.
#pragma once

#include <vector>

#include "contact/stick_slip_system.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief Conditions at an instant, common to all solvers of its linear systems.
class TransientStickSlipSystem : public StickSlipSystem {
 public:
  [[nodiscard]] ConditionScales scales() const override { return scales_; }
  [[nodiscard]] double load() const override { return problem_.load; }
  [[nodiscard]] Eigen::Index first_node() const override { return 0; }
  [[nodiscard]] int products() const override { return products_; }

  void find_displacements(ContactSolution& state) override;

 protected:
  /// @param[in] problem must outlive this object
  /// @param[in] displaced displacements under a guess of the forces; may be empty if the condition on the center does
  /// not depend on them
  TransientStickSlipSystem(const StickSlipProblem& problem, const std::vector<HalfField>& displaced);

  [[nodiscard]] const StickSlipProblem& problem() const { return problem_; }
  /// @return condition on the center, for the displacements found last
  [[nodiscard]] const CenterRow& center() const { return center_; }
  /// @return residual of the condition on the center [N]
  [[nodiscard]] double center_excess(const ContactSolution& state) const;
  /// @return whether a node is in the middle of its row, where the sideways displacement is zero
  [[nodiscard]] bool in_middle(Eigen::Index node) const { return node % problem_.surface.half_nodes() == 0; }
  void count_products(int more) { products_ += more; }

 private:
  const StickSlipProblem& problem_;
  ConditionScales scales_;
  CenterRow center_;
  int products_ = 0;
};

}  // namespace viscoroll::detail
