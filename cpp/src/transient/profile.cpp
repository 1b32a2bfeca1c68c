#include "viscoroll/profile.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/validate.hpp"

namespace viscoroll {

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
