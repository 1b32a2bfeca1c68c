/// @file
/// @brief Height profiles of the ground along the track and of the tread around the rolling body.
#pragma once

#include <string_view>
#include <tuple>
#include <variant>
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

/// @brief Step up, or down if the height is negative.
struct StepShape {
  double height = 0.0;  ///< height of the ground behind the step [m]
  double at = 0.0;      ///< distance of the step [m]

  static constexpr const char* type = "step";
  static constexpr auto fields() {
    return std::tuple{Field{"height", &StepShape::height}, Field{"at", &StepShape::at}};
  }
};

/// @brief Bump with the shape of half a sine period, or a dip if the height is negative.
struct HalfSineShape {
  double height = 0.0;  ///< height of the top [m]
  double length = 0.0;  ///< length of the bump [m], > 0
  double at = 0.0;      ///< distance of the top [m]

  static constexpr const char* type = "half_sine";
  static constexpr auto fields() {
    return std::tuple{Field{"height", &HalfSineShape::height}, Field{"length", &HalfSineShape::length},
                      Field{"at", &HalfSineShape::at}};
  }
};

/// @brief Joint between two plates: a groove with vertical walls.
struct JointShape {
  double depth = 0.0;  ///< depth of the joint [m], > 0
  double width = 0.0;  ///< width along the track [m], > 0
  double at = 0.0;     ///< distance of the middle of the joint [m]

  static constexpr const char* type = "joint";
  static constexpr auto fields() {
    return std::tuple{Field{"depth", &JointShape::depth}, Field{"width", &JointShape::width},
                      Field{"at", &JointShape::at}};
  }
};

/// @brief Periodic profile, amplitude * sin(2 pi (distance - at) / period).
struct CorrugationShape {
  double amplitude = 0.0;  ///< amplitude [m]
  double period = 0.0;     ///< length of a period [m], > 0
  double at = 0.0;         ///< distance at which the height rises through zero [m]

  static constexpr const char* type = "corrugation";
  static constexpr auto fields() {
    return std::tuple{Field{"amplitude", &CorrugationShape::amplitude}, Field{"period", &CorrugationShape::period},
                      Field{"at", &CorrugationShape::at, true}};
  }
};

/// @brief Shape of an obstacle.
using ProfileShape = std::variant<StepShape, HalfSineShape, JointShape, CorrugationShape>;

/// @brief Points of a shape. The chords of a half sine of 1 mm are off by less than 2e-9 m.
/// @throws InvalidInput naming parameter, value, unit and range
[[nodiscard]] HeightProfile profile_of(const ProfileShape& shape);

}  // namespace viscoroll
