/// @file
/// @brief Which steps of time a history takes from one knot to the next.
#pragma once

#include <optional>
#include <vector>

namespace viscoroll::detail {

/// @brief A straight piece of a motion.
struct Leg {
  double duration;       ///< [s], >= 0
  double turn;           ///< [rad]
  double relative_load;  ///< change of load per the larger load [-]
};

/// @param[in] spacing,steps_per_spacing as of `StepChoice`
/// @return how far a leg may turn for its steps to fit into memory [rad]
[[nodiscard]] double most_turn(double spacing, std::optional<int> steps_per_spacing);

/// @return change per the larger of two values, neither below 0 [-]
[[nodiscard]] double relative_change(double before, double after);

/// @brief By spacing while it rolls; after an event, and at standstill, from short steps to longer ones.
class StepChoice {
 public:
  /// @param[in] spacing along phi [rad]
  /// @param[in] steps_per_spacing none: one step for each leg
  /// @param[in] shortest_time shortest retardation time [s]; infinite without one
  StepChoice(double spacing, std::optional<int> steps_per_spacing, double shortest_time)
      : spacing_(spacing), steps_per_spacing_(steps_per_spacing), shortest_time_(shortest_time) {}

  /// @param[in] leg ahead
  /// @param[in] last the step before it [s], 0 after a jump and at the start
  /// @return ends of the steps as shares of the leg, ascending to 1
  [[nodiscard]] std::vector<double> shares(const Leg& leg, double last) const;

 private:
  double spacing_;
  std::optional<int> steps_per_spacing_;
  double shortest_time_;
};

}  // namespace viscoroll::detail
