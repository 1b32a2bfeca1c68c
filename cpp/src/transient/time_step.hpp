/// @file
/// @brief Time steps of a history: how a segment from one waypoint to the next is divided into steps, and how a step
/// changes the memory of a node, whose force is linear in time during the step.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "materials/creep_spectrum.hpp"
#include "transient/numbers.hpp"

namespace viscoroll::detail {

/// @brief End of a step, in which angle, load and a given displacement of the center change linearly.
struct StepEnd {
  double time;                                ///< [s]
  double angle;                               ///< [rad]
  double load;                                ///< [N]
  std::optional<double> center_displacement;  ///< displacement since the first instant [m]; none if forces decide
  std::optional<double> axle_height = {};     ///< height of the axle [m], which replaces the load

  bool operator==(const StepEnd&) const = default;
};

/// @brief Exponential integration of lambda_j a_j' + a_j = F. It is exact for forces that are linear in time, hence of
/// second order in the step. See docs/theory/transient.md.
struct TimeStep {
  /// Coefficients of a term of the spectrum: a_new = decay a + on_old F_old + on_new F_new. The energy that it
  /// dissipates is lost_change dF.K dF + lost_mixed dF.K e + lost_state e.K e with dF = F_new - F_old and e = F_old -
  /// a.
  struct Term {
    double weight;  ///< J_j
    double decay;
    double on_old;
    double on_new;
    double lost_change;
    double lost_mixed;
    double lost_state;
  };

  /// @param[in] spectrum spectrum of the coating
  /// @param[in] duration [s], 0 for a jump
  TimeStep(const CreepSpectrum& spectrum, double duration);

  double compliance;  ///< c = J_0 + sum J_j on_new: compliance for the new force at the end of the step
  std::vector<Term> terms;
};

/// @brief A step of all bodies.
struct PairStep {
  double duration;                 ///< [s], 0 for a jump
  std::vector<TimeStep> parts;     ///< one for each body
  double contact_stiffness = 0.0;  ///< estimate for impacts, if there is an axle [N/m]
};

/// @brief A segment of a motion between two waypoints.
struct Segment {
  double duration;       ///< [s], >= 0
  double turn;           ///< [rad]
  double relative_load;  ///< change of the load relative to the larger load [-]
  /// Longest step that resolves the vibration of the axle [s]
  double longest_step = std::numeric_limits<double>::infinity();
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

/// @brief Write a started segment, or that there is none, into a saved state.
void write(const std::optional<StartedSegment>& started, NumberWriter& numbers);

/// @brief Read what `write` has written.
/// @throws InvalidInput if the numbers do not form a segment
[[nodiscard]] std::optional<StartedSegment> read_started_segment(NumberReader& numbers);

}  // namespace viscoroll::detail
