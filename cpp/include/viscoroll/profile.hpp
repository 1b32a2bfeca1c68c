/// @file
/// @brief Height profiles of the ground along the track and of the tread around the rolling body.
#pragma once

#include <string_view>
#include <tuple>
#include <vector>

#include "viscoroll/fields.hpp"

namespace viscoroll {

/// @brief Height over distance, linear between points. Two points at one distance are a step. Outside its points, a
/// profile keeps the height of its first or last point, or it repeats.
struct HeightProfile {
  std::vector<double> distance;  ///< distances along the track, not decreasing, at least two [m]
  std::vector<double> height;    ///< height above the smooth surface at each distance [m]
  bool periodic = false;         ///< whether the profile repeats; the period is the range of the distances

  static constexpr auto fields() {
    return std::tuple{Field{"distance", &HeightProfile::distance}, Field{"height", &HeightProfile::height},
                      Field{"periodic", &HeightProfile::periodic, true}};
  }

  friend bool operator==(const HeightProfile&, const HeightProfile&) = default;
};

/// @brief Check a profile.
/// @param[in] profile profile to check
/// @param[in] path prefix of the parameter names in messages, such as "ground."
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const HeightProfile& profile, std::string_view path = "");

/// @return height at a distance [m]; at a step, that of the second point
[[nodiscard]] double height_at(const HeightProfile& profile, double distance);

}  // namespace viscoroll
