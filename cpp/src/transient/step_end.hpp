/// @file
/// @brief Where a step ends.
#pragma once

#include <optional>

namespace viscoroll::detail {

/// @brief Where a step ends, in which angle, load and a given way of the center change linearly.
struct StepEnd {
  double time;                       ///< [s]
  double angle;                      ///< [rad]
  double load;                       ///< [N]
  std::optional<double> center_way;  ///< since the first instant [m]; none: forces decide

  bool operator==(const StepEnd&) const = default;
};

}  // namespace viscoroll::detail
