/// @file
/// @brief Stick and slip of what rolls over what it rolls on: nodes slip from where they were a step ago.
#pragma once

#include <vector>

#include "contact/stick_slip_system.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief The conditions of an instant, whoever solves its linear systems.
class MatchedSurfaces : public StickSlipSystem {
 public:
  [[nodiscard]] ConditionScales scales() const override { return scales_; }
  [[nodiscard]] double load() const override { return problem_.load; }
  [[nodiscard]] Eigen::Index first_node() const override { return 0; }
  [[nodiscard]] int products() const override { return products_; }

  void find_displacements(ContactSolution& state) override;

 protected:
  /// @param[in] problem which outlives this object
  /// @param[in] displaced by a guess of the forces; may be empty where the center's condition knows none
  MatchedSurfaces(const StickSlipProblem& problem, const std::vector<HalfField>& displaced);

  [[nodiscard]] const StickSlipProblem& problem() const { return problem_; }
  /// @return what holds for the center, by the displacements that were found last
  [[nodiscard]] const CenterRow& center() const { return center_; }
  /// @return how far a state is from that [N]
  [[nodiscard]] double center_excess(const ContactSolution& state) const;
  /// @return whether a node is in the middle of its row, where nothing moves sideways
  [[nodiscard]] bool in_middle(Eigen::Index node) const { return node % problem_.surface.half_nodes() == 0; }
  void count_products(int more) { products_ += more; }

 private:
  const StickSlipProblem& problem_;
  ConditionScales scales_;
  CenterRow center_;
  int products_ = 0;
};

}  // namespace viscoroll::detail
