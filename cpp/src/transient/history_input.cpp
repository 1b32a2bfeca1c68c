#include "transient/history_input.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "influence/table_sums.hpp"

namespace viscoroll {
namespace detail {
namespace {

constexpr int kMaxStepsPerSpacing = 64;

}  // namespace

/// Mesh with 16 nodes across the contact at rest. A line contact has three times as many, because no neighboring nodes
/// across smooth its staircase.
Mesh chosen_mesh(double outer_radius, double contact_radius, bool is_line) {
  const double across = is_line ? 48.0 : 16.0;
  constexpr double kFewest = 64.0;
  constexpr double kMaxNodes = 4000.0;
  const double nodes = std::numbers::pi * outer_radius / contact_radius * across;
  return {.nodes_per_revolution = 2 * static_cast<int>(std::lround(0.5 * std::clamp(nodes, kFewest, kMaxNodes)))};
}

void validate(const HistoryOptions& options) {
  if (options.mesh) viscoroll::validate(*options.mesh);
  require_orders(options.curvature);
  require_count("averaged_meshes", options.averaged_meshes, 1, kMaxAveragedMeshes);
  if (options.steps_per_spacing) {
    require_count("steps_per_spacing", *options.steps_per_spacing, 1, kMaxStepsPerSpacing);
  }
  require_friction(options.friction);
  if (std::isinf(options.friction)) {
    reject("friction", "finite in transient rolling, where nodes slip when they enter the contact", options.friction);
  }
  require_finite("driving_force", options.driving_force);
  if (options.driving_torque) {
    require_finite("driving_torque", *options.driving_torque);
    if (options.friction == 0.0) {
      reject("driving_torque", "left out without friction, where the torque follows from the pressure",
             text(*options.driving_torque) + " N m");
    }
    if (options.driving_force != 0.0) {
      reject("driving_force", "0 N if driving_torque is given", text(options.driving_force) + " N");
    }
    if (options.mass > 0.0) {
      reject("mass", "0 kg if driving_torque is given, with which the forces balance", text(options.mass) + " kg");
    }
  }
  require_nonnegative("mass", options.mass, "kg");
  require_finite("center_speed", options.center_speed);
  if (options.mass > 0.0 && options.friction == 0.0) {
    reject("mass", "0 kg without friction, where only a force on the center would move it", text(options.mass) + " kg");
  }
  if (options.center_speed != 0.0 && options.mass == 0.0) {
    reject("center_speed", "0 m/s without a mass", text(options.center_speed) + " m/s");
  }
  if (options.ground) viscoroll::validate(*options.ground, "ground.");
  if (options.tread) viscoroll::validate(*options.tread, "tread.");
  if (options.axle) viscoroll::validate(*options.axle);
  require_positive("shortest_time", options.shortest_time, "s");
  if (!(std::isfinite(options.longest_time) && options.longest_time > options.shortest_time)) {
    reject("longest_time", "> shortest_time = " + text(options.shortest_time) + " s", options.longest_time,
           Range{.unit = "s", .minimum = options.shortest_time, .excludes_minimum = true});
  }
  require_in({.minimum = 0.0, .maximum = 1.0, .excludes_minimum = true, .excludes_maximum = true}, "spectrum_tolerance",
             options.spectrum_tolerance);
  require_thread_count(options.threads);
}

}  // namespace detail

void validate(const Axle& axle) {
  detail::require_nonnegative("axle.mass", axle.mass, "kg");
  detail::require_nonnegative("axle.stiffness", axle.stiffness, "N/m");
  detail::require_nonnegative("axle.damping", axle.damping, "N s/m");
  if (axle == Axle{}) detail::reject("axle", "an axle with a mass, a spring or a damper", "an axle without them");
}

void validate(const Motion& motion) {
  const auto require_length = [&](const char* name, std::size_t length) {
    if (length != motion.time.size()) {
      detail::reject(name, "as long as time (" + std::to_string(motion.time.size()) + ")", std::to_string(length));
    }
  };
  if (motion.time.empty()) detail::reject("time", "a list of at least one waypoint", "none");
  require_length("angle", motion.angle.size());
  if (!motion.axle_height.empty() && !motion.load.empty()) {
    detail::reject("axle_height", "left out if the load is given",
                   std::to_string(motion.axle_height.size()) + " heights");
  }
  if (motion.axle_height.empty()) {
    require_length("load", motion.load.size());
  } else {
    require_length("axle_height", motion.axle_height.size());
  }
  if (!motion.center_displacement.empty()) require_length("center_displacement", motion.center_displacement.size());
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    const std::string index = "[" + std::to_string(k) + "]";
    detail::require_finite("time" + index, motion.time[k]);
    detail::require_finite("angle" + index, motion.angle[k]);
    if (motion.axle_height.empty()) detail::require_nonnegative("load" + index, motion.load[k], "N");
    if (!motion.axle_height.empty()) detail::require_finite("axle_height" + index, motion.axle_height[k]);
    if (!motion.center_displacement.empty())
      detail::require_finite("center_displacement" + index, motion.center_displacement[k]);
    if (k > 0 && motion.time[k] < motion.time[k - 1]) {
      detail::reject("time" + index,
                     ">= time[" + std::to_string(k - 1) + "] = " + detail::text(motion.time[k - 1]) + " s",
                     detail::text(motion.time[k]) + " s");
    }
  }
  if (!motion.center_displacement.empty() && motion.center_displacement.front() != 0.0) {
    detail::reject("center_displacement[0]", "0 m, because the displacement is measured from the first instant",
                   detail::text(motion.center_displacement.front()) + " m");
  }
}

}  // namespace viscoroll
