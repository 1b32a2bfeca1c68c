/// @file
/// @brief A segment of a motion of which some steps have been taken.
#pragma once

#include <cstddef>
#include <optional>

#include "transient/numbers.hpp"
#include "transient/step_end.hpp"

namespace viscoroll::detail {

/// @brief Segment from one waypoint to the next, as it was when its first step began: a resumed segment uses identical
/// steps.
struct StartedSegment {
  StepEnd begin;
  StepEnd end;
  double last_step;   ///< step before the segment [s]
  std::size_t taken;  ///< number of steps taken in the segment

  /// @return instant at a fraction of the segment, which is linear in time
  [[nodiscard]] StepEnd at(double share) const;
};

void write(const std::optional<StartedSegment>& started, NumberWriter& numbers);

/// @throws InvalidInput if the numbers do not form a segment
[[nodiscard]] std::optional<StartedSegment> read_started_segment(NumberReader& numbers);

}  // namespace viscoroll::detail
