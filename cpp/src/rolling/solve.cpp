// Public face of the library: checks the input once and dispatches.
#include "viscoroll/solve.hpp"

#include <cmath>

#include "modal/critical_speed.hpp"
#include "modal/medium.hpp"
#include "parallel.hpp"
#include "rolling/refinement.hpp"
#include "rolling/rolling_contact.hpp"
#include "validate.hpp"

namespace viscoroll {
namespace {

void validate(const LoadCase& load_case) {
  detail::require_positive("load", load_case.load, "N");
  detail::require_positive("angular_speed", load_case.angular_speed, "rad/s");
}

void validate(const Options& options) {
  if (options.mesh) viscoroll::validate(*options.mesh);
  if (!(options.accuracy >= 1e-4 && options.accuracy <= 0.5)) {
    detail::reject("accuracy", "in [1e-4, 0.5]", options.accuracy);
  }
  if (options.max_iterations < 1) detail::reject("max_iterations", ">= 1", std::to_string(options.max_iterations));
  if (options.threads < 0) detail::reject("threads", ">= 0", std::to_string(options.threads));
}

}  // namespace

Result solve(const CoatedSphere& sphere, const LoadCase& load_case, const Options& options) {
  validate(sphere);
  validate(load_case);
  validate(options);
  detail::Watch watch(options.observer);
  if (!options.mesh) return detail::solve_to_accuracy(sphere, load_case, options, watch);
  const detail::HarmonicCoating coating(sphere, load_case.angular_speed, detail::orders_up_to(options.mesh->max_order));
  return detail::solve_on_mesh(coating, load_case, *options.mesh, options, watch);
}

}  // namespace viscoroll
