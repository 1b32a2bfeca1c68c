#include "viscoroll/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "base/validate.hpp"

namespace viscoroll {
namespace {

/// Points of a part of a sine, which ends at height 0 without the round-off of sin(pi).
HeightProfile sine(double height, double first, double length, double periods) {
  constexpr int kPoints = 1001;
  HeightProfile profile;
  for (int k = 0; k < kPoints; ++k) {
    const double share = static_cast<double>(k) / (kPoints - 1);
    profile.distance.push_back(first + length * share);
    profile.height.push_back(k + 1 < kPoints ? height * std::sin(2.0 * std::numbers::pi * periods * share) : 0.0);
  }
  return profile;
}

HeightProfile points(const StepShape& step) {
  constexpr double kBeside = 1.0;  // distance to the ends of the profile [m], beyond which the heights are the same
  return {.distance = {step.at - kBeside, step.at, step.at, step.at + kBeside},
          .height = {0.0, 0.0, step.height, step.height}};
}

HeightProfile points(const HalfSineShape& bump) {
  detail::require_positive("length", bump.length, "m");
  return sine(bump.height, bump.at - 0.5 * bump.length, bump.length, 0.5);
}

HeightProfile points(const JointShape& joint) {
  detail::require_positive("depth", joint.depth, "m");
  detail::require_positive("width", joint.width, "m");
  const double first = joint.at - 0.5 * joint.width;
  const double last = joint.at + 0.5 * joint.width;
  return {.distance = {first, first, last, last}, .height = {0.0, -joint.depth, -joint.depth, 0.0}};
}

HeightProfile points(const CorrugationShape& waves) {
  detail::require_positive("period", waves.period, "m");
  HeightProfile profile = sine(waves.amplitude, waves.at, waves.period, 1.0);
  profile.periodic = true;
  return profile;
}

}  // namespace

HeightProfile profile_of(const ProfileShape& shape) {
  return std::visit([](const auto& kind) { return points(kind); }, shape);
}

void validate(const HeightProfile& profile, std::string_view path) {
  const std::string prefix(path);
  const std::size_t count = profile.distance.size();
  if (count < 2) {
    detail::reject(prefix + "distance", "a list of at least two distances", std::to_string(count) + " distances");
  }
  if (profile.height.size() != count) {
    detail::reject(prefix + "height", "as long as distance (" + std::to_string(count) + ")",
                   std::to_string(profile.height.size()));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto entry = [&](std::string_view name) {
      return prefix + std::string(name) + "[" + std::to_string(k) + "]";
    };
    detail::require_finite(entry("distance"), profile.distance[k]);
    detail::require_finite(entry("height"), profile.height[k]);
    if (k > 0 && profile.distance[k] < profile.distance[k - 1]) {
      detail::reject(entry("distance"),
                     ">= distance[" + std::to_string(k - 1) + "] = " + detail::text(profile.distance[k - 1]) + " m",
                     detail::text(profile.distance[k]) + " m", Range{.unit = "m", .minimum = profile.distance[k - 1]});
    }
  }
  if (!(profile.distance.back() > profile.distance.front())) {
    detail::reject(prefix + "distance", "a list of different distances",
                   "only " + detail::text(profile.distance.front()) + " m");
  }
}

double height_at(const HeightProfile& profile, double distance) {
  const std::vector<double>& points = profile.distance;
  const double first = points.front();
  const double last = points.back();
  if (profile.periodic) {
    const double period = last - first;
    distance -= period * std::floor((distance - first) / period);
  }
  if (distance < first) return profile.height.front();
  if (distance >= last) return profile.height.back();
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(points, distance) - points.begin());
  const double share = (distance - points[after - 1]) / (points[after] - points[after - 1]);
  return std::lerp(profile.height[after - 1], profile.height[after], share);
}

}  // namespace viscoroll
