/// @file
/// @brief An end to steps of frictional contact that go back and forth between two states of a node.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "contact/stick_slip_conditions.hpp"

namespace viscoroll::detail {

/// @brief Ends cycles of two sets, and of two directions of slip. A node at the edge, where its own traction relieves
/// it of pressure, may neither stick (|t| > mu p) nor slip (t along S): its third choice, to leave the plane, is not
/// seen from either side. Nor is rest from slip to and fro.
class CycleBreaker {
 public:
  explicit CycleBreaker(Eigen::Index nodes) : now_(static_cast<std::size_t>(nodes)), last_(now_), before_last_(now_) {}

  /// Take nodes out of contact for one step that changed their minds twice, if all others kept to theirs.
  /// @param[in] progresses whether the residual fell meanwhile, and nothing goes back and forth
  /// @return whether there were any
  bool free_undecided(ContactSets& sets, bool progresses) {
    before_last_.swap(last_);
    last_.swap(now_);
    std::ranges::fill(now_, kApart);
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

  /// Let nodes stick for one step whose slip turned round in the last one: they passed their place of rest.
  void rest_turned(ContactSets& sets) {
    directions_.resize(now_.size(), {0.0, 0.0});
    std::vector<Eigen::Array2d> turned(now_.size(), {0.0, 0.0});
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      TangentialState& state = sets.states[i];
      if (state.stick) continue;
      const auto node = static_cast<std::size_t>(sets.contact[i]);
      if ((state.direction * directions_[node]).sum() < kTurned) {
        state = sticking();
      } else {
        turned[node] = state.direction;
      }
    }
    directions_ = std::move(turned);
  }

 private:
  static constexpr double kTurned = 0.0;  // cosine of a turn
  enum State : unsigned char { kApart, kStick, kSlip };
  std::vector<State> now_, last_, before_last_;
  std::vector<Eigen::Array2d> directions_;  // of slip, a step ago; 0 of nodes that did not
};

}  // namespace viscoroll::detail
