/// @file
/// @brief Choice of the time steps of a history from one waypoint to the next.
#pragma once

#include <optional>
#include <vector>

namespace viscoroll::detail {

/// @brief A segment of a motion between two waypoints.
struct Segment {
  double duration;       ///< [s], >= 0
  double turn;           ///< [rad]
  double relative_load;  ///< change of the load relative to the larger load [-]
};

/// @param[in] spacing,steps_per_spacing same as in `StepChoice`
/// @return largest turn of a segment whose steps fit into memory [rad]
[[nodiscard]] double max_turn(double spacing, std::optional<int> steps_per_spacing);

/// @return change relative to the larger of two values, neither of them negative [-]
[[nodiscard]] double relative_change(double before, double after);

/// @brief Choice of time steps: by the spacing while the body rolls; after an event, and at standstill, from short
/// steps to longer ones.
class StepChoice {
 public:
  /// @param[in] spacing along phi [rad]
  /// @param[in] steps_per_spacing none: one step for each segment
  /// @param[in] shortest_time shortest retardation time [s]; infinite if there is none
  StepChoice(double spacing, std::optional<int> steps_per_spacing, double shortest_time)
      : spacing_(spacing), steps_per_spacing_(steps_per_spacing), shortest_time_(shortest_time) {}

  /// @param[in] segment next segment
  /// @param[in] last previous step [s], 0 after a jump and at the start
  /// @return ends of the steps as fractions of the segment, ascending to 1
  [[nodiscard]] std::vector<double> fractions(const Segment& segment, double last) const;

 private:
  double spacing_;
  std::optional<int> steps_per_spacing_;
  double shortest_time_;
};

}  // namespace viscoroll::detail
