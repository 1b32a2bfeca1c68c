/// @file
/// @brief Detection of cycles in which nodes alternate between two states of frictional contact.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "contact/stick_slip_conditions.hpp"

namespace viscoroll::detail {

/// @brief Ends cycles between two sets of nodes and between two directions of slip.
/// A node at the edge whose own traction relieves it of pressure may neither stick (|t| > mu p) nor slip (t along S),
/// so the two sets alternate; the third choice, to leave the contact, appears in neither. A node whose slip changes
/// sign from step to step does not converge either.
class CycleBreaker {
 public:
  explicit CycleBreaker(Eigen::Index nodes) : now_(static_cast<std::size_t>(nodes)), last_(now_), before_last_(now_) {}

  /// Take nodes that changed their state twice out of contact for one step, if all other nodes kept their states.
  /// @param[in,out] sets sets of the next step
  /// @param[in] progresses whether the residual fell meanwhile; if so, there is no cycle
  /// @return whether any node was taken out
  bool release_alternating(ContactSets& sets, bool progresses) {
    before_last_.swap(last_);
    last_.swap(now_);
    std::ranges::fill(now_, kSeparated);
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      now_[static_cast<std::size_t>(sets.contact[i])] = sets.states[i].stick ? kStick : kSlip;
    }
    if (progresses || now_ != before_last_ || now_ == last_) return false;
    ContactSets kept;
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      const auto node = static_cast<std::size_t>(sets.contact[i]);
      if (now_[node] != last_[node]) continue;
      kept.contact.push_back(sets.contact[i]);
      kept.states.push_back(sets.states[i]);
    }
    sets = std::move(kept);
    return true;
  }

  /// Make nodes stick for one step if their slip reversed in the last step, since they passed their position of rest.
  void stick_reversed(ContactSets& sets) {
    directions_.resize(now_.size(), {0.0, 0.0});
    std::vector<Eigen::Array2d> slipping(now_.size(), {0.0, 0.0});
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      TangentialState& state = sets.states[i];
      if (state.stick) continue;
      const auto node = static_cast<std::size_t>(sets.contact[i]);
      if ((state.direction * directions_[node]).sum() < kReversedCosine) {
        state = sticking();
      } else {
        slipping[node] = state.direction;
      }
    }
    directions_ = std::move(slipping);
  }

 private:
  static constexpr double kReversedCosine = 0.0;  // cosine of the angle beyond which slip counts as reversed
  enum State : unsigned char { kSeparated, kStick, kSlip };
  std::vector<State> now_, last_, before_last_;
  std::vector<Eigen::Array2d> directions_;  // directions of slip one step ago; 0 for nodes that did not slip
};

}  // namespace viscoroll::detail
