/// @file
/// @brief Circular profiles.
#pragma once

#include <algorithm>
#include <cmath>

namespace viscoroll::detail {

/// @brief Depth of a circle below its highest point, 1/k - sqrt(1/k^2 - x^2), without the round-off of small
/// curvatures.
/// @param[in] x horizontal distance from the highest point [m]; beyond the radius 1/k the depth is k x^2
/// @param[in] curvature curvature k [1/m]
/// @return depth [m]
[[nodiscard]] inline double drop_of_circle(double x, double curvature) {
  const double slope = curvature * x;
  return slope * x / (1.0 + std::sqrt(std::max(1.0 - slope * slope, 0.0)));
}

}  // namespace viscoroll::detail
