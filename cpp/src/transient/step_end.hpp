/// @file
/// @brief End of a time step.
#pragma once

#include <optional>

namespace viscoroll::detail {

/// @brief End of a step, in which angle, load and a given displacement of the center change linearly.
struct StepEnd {
  double time;                                ///< [s]
  double angle;                               ///< [rad]
  double load;                                ///< [N]
  std::optional<double> center_displacement;  ///< displacement since the first instant [m]; none if forces decide

  bool operator==(const StepEnd&) const = default;
};

}  // namespace viscoroll::detail
