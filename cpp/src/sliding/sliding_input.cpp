#include "sliding/sliding_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll {
namespace {

constexpr int kFewestNodes = 8;
constexpr int kMostNodes = 16384;

void require_nodes(const char* name, int count, bool may_be_one) {
  if ((may_be_one && count == 1) || (count >= kFewestNodes && count <= kMostNodes)) return;
  const std::string range = "in [" + std::to_string(kFewestNodes) + ", " + std::to_string(kMostNodes) + "]";
  detail::reject(name, (may_be_one ? "1 or " : "") + range, std::to_string(count));
}

}  // namespace

void validate(const HeightMap& map) {
  require_nodes("heights.rows", map.rows, false);
  require_nodes("heights.columns", map.columns, true);
  const auto count = static_cast<std::size_t>(map.rows) * static_cast<std::size_t>(map.columns);
  if (map.heights.size() != count) {
    detail::reject("heights", "one number for each of the " + std::to_string(count) + " nodes",
                   std::to_string(map.heights.size()));
  }
  for (const double height : map.heights) {
    if (!(std::abs(height) <= detail::kLargestNumber)) detail::reject("heights", "finite", height);
  }
  detail::require_positive("spacing_x", map.spacing_x, "m");
  if (map.columns > 1) detail::require_positive("spacing_z", map.spacing_z, "m");
}

}  // namespace viscoroll

namespace viscoroll::detail {

void validate_below(const CoatedPlane& on) {
  try {
    validate(on);
  } catch (const InvalidInput& error) {
    throw error.inside("on");
  }
  if (is_rigid(on)) reject("on", "a plane with layers or a deformable base", "a rigid plane");
}

void validate_sliding(const HeightMap& map, const CoatedPlane& on, double pressure, double speed,
                      const SlidingOptions& options) {
  validate(map);
  validate_below(on);
  require_positive("pressure", pressure, "Pa");
  require_nonnegative("speed", speed, "m/s");
  if (speed > 0.0) require_positive("speed", speed, "m/s");
  require_nonnegative("friction", options.friction, "");
  if (options.friction > 0.0 && speed == 0.0) reject("speed", "> 0 m/s with friction", speed);
  constexpr double kStrictest = 1e-13;
  constexpr double kLoosest = 1e-3;
  require_in({.minimum = kStrictest, .maximum = kLoosest}, "tolerance", options.tolerance);
  require_in({.minimum = 1.0}, "max_iterations", options.max_iterations);
  require_thread_count(options.threads);
}

SlidingPeriod period_of(const HeightMap& map) {
  return {.nodes = {map.rows, map.columns},
          .length_x = map.rows * map.spacing_x,
          .length_z = map.columns > 1 ? map.columns * map.spacing_z : 1.0};
}

std::vector<double> heights_against_path(const HeightMap& map) { return with_reversed_rows(map.heights, map.columns); }

std::vector<double> with_reversed_rows(const std::vector<double>& values, int columns) {
  std::vector<double> reversed;
  reversed.reserve(values.size());
  for (auto end = values.end(); end != values.begin(); end -= columns)
    reversed.insert(reversed.end(), end - columns, end);
  return reversed;
}

}  // namespace viscoroll::detail
