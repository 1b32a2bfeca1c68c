// Public interface of the library: checks the input once and calls the solver.
#include "viscoroll/solve.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/invalid_speed.hpp"
#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "rolling/adhesion.hpp"
#include "rolling/contact_setup.hpp"
#include "rolling/drives.hpp"
#include "rolling/finite_strain.hpp"
#include "rolling/mesh_model.hpp"
#include "rolling/refinement.hpp"
#include "rolling/solve_load_case.hpp"
#include "rolling/warnings.hpp"

namespace viscoroll {
namespace {

detail::GivenSpeed given_speed(const LoadCase& load_case) {
  if (load_case.speed) return {.parameter = "speed", .value = *load_case.speed, .unit = "m/s"};
  return {.parameter = "angular_speed", .value = load_case.angular_speed, .unit = "rad/s"};
}

void require_speed(const LoadCase& load_case) {
  const detail::GivenSpeed given = given_speed(load_case);
  detail::require_positive(given.parameter, given.value, given.unit);
}

/// Angular speed at which linear theory is solved [rad/s].
double angular_speed_of(const LoadCase& load_case, const detail::RoundBody& body) {
  return load_case.speed ? *load_case.speed / body.radius() : load_case.angular_speed;
}

void validate(const LoadCase& load_case, const detail::RoundBody& body) {
  if (load_case.load && load_case.penetration) {
    detail::reject("penetration", "left out if the load is given", detail::text(*load_case.penetration) + " m");
  }
  if (load_case.pulls_off) {
    if (load_case.load) detail::reject("load", "left out for the largest tension", *load_case.load);
    if (load_case.penetration)
      detail::reject("penetration", "left out for the largest tension", *load_case.penetration);
  } else if (load_case.load && load_case.adhesion) {
    detail::require_finite("load", *load_case.load);
  } else if (load_case.load) {
    detail::require_positive("load", *load_case.load, body.form().load_unit);
  } else if (load_case.penetration) {
    detail::require_finite("penetration", *load_case.penetration);
  } else {
    detail::reject("load", "given, or penetration instead of it", "neither");
  }
  require_speed(load_case);
  if (load_case.speed) {
    if (load_case.angular_speed != 0.0) {
      detail::reject("speed", "left out if the angular speed is given", detail::text(*load_case.speed) + " m/s");
    }
    if (load_case.friction != 0.0) {
      detail::reject("speed", "left out with friction, which determines it", detail::text(*load_case.speed) + " m/s");
    }
  }
  detail::require_friction(load_case.friction);
  detail::validate_drive(load_case, body);
}

void validate(const Options& options) {
  if (options.mesh) viscoroll::validate(*options.mesh);
  detail::require_in({.minimum = 1e-4, .maximum = 0.5}, "accuracy", options.accuracy);
  detail::require_in({.minimum = 1.0}, "max_iterations", options.max_iterations);
  detail::require_thread_count(options.threads);
}

/// A checked load case whose speed is expressed as the angular speed of linear theory.
LoadCase checked(LoadCase load_case, const detail::RoundBody& body) {
  validate(load_case, body);
  load_case.angular_speed = angular_speed_of(load_case, body);
  return load_case;
}

struct CheckedCase {
  detail::PairAtSpeed pair;
  LoadCase load_case;
};

/// Check all input values, and combine both bodies at the speed of the load case.
CheckedCase checked(const RollingBody& body, const Counterbody& on, const LoadCase& load_case, const Options& options) {
  const detail::RollingPair pair = detail::rolling_pair(body, on);
  const LoadCase at_speed = checked(load_case, *pair.body);
  validate(options);
  return {.pair = detail::at_speed(pair, at_speed.angular_speed), .load_case = at_speed};
}

detail::MeshModel model_on_given_mesh(const detail::RollingCase& given) {
  return detail::make_model(given.pair, *given.options.mesh, given.options.curvature, given.execution);
}

/// Add what the result does not contain: the estimate of adhesion, and warnings.
Result with_notes(Result result, const detail::RollingCase& given, bool mesh_given) {
  result.clean_adhesion_increase = detail::clean_adhesion_increase(given, result);
  result.warnings = detail::warnings_of(result, given, mesh_given);
  return result;
}

/// Solve a load case on a given mesh, with the results at finite strain.
Result solve_on(const detail::MeshModel& model, const detail::RollingCase& given, detail::FasterModel& faster) {
  Result result = detail::solve_load_case(model, given);
  detail::add_finite_strain(result, std::nullopt, given, faster);
  return result;
}

}  // namespace

Result solve(const RollingBody& body, const LoadCase& load_case, const Options& options) {
  return solve(body, CoatedPlane{}, load_case, options);
}

Result solve(const RollingBody& body, const Counterbody& on, const LoadCase& load_case, const Options& options) {
  return detail::with_given_speed(given_speed(load_case), [&] {
    const auto [pair, at_speed] = checked(body, on, load_case, options);
    detail::Watch watch(options.observer);
    const detail::RollingCase given = detail::rolling_case(pair, at_speed, options, watch);
    if (!options.mesh) return with_notes(detail::solve_to_accuracy(given), given, false);
    detail::FasterModel faster;
    return with_notes(solve_on(model_on_given_mesh(given), given, faster), given, true);
  });
}

Result solve_frozen(const RollingBody& body, const Counterbody& on, const LoadCase& load_case,
                    const FrozenContact& state, const Options& options) {
  return detail::with_given_speed(given_speed(load_case), [&] {
    const auto [pair, at_speed] = checked(body, on, load_case, options);
    if (!options.mesh) detail::reject("mesh", "the mesh of the state", "none");
    if (load_case.adhesion) detail::reject("adhesion", "left out for a frozen contact", "an adhesion");
    detail::Watch watch(options.observer);
    const detail::RollingCase given = detail::rolling_case(pair, at_speed, options, watch);
    return with_notes(detail::solve_frozen_case(model_on_given_mesh(given), given, state), given, true);
  });
}

struct RollingModel::Impl {
  detail::MeshModel model;
  detail::FasterModel faster;
};

RollingModel::RollingModel(const RollingBody& body, double angular_speed, const Mesh& mesh, int threads,
                           Curvature curvature, const Observer& observer)
    : RollingModel(body, CoatedPlane{}, angular_speed, mesh, threads, curvature, observer) {}

RollingModel::RollingModel(const RollingBody& body, const Counterbody& on, double angular_speed, const Mesh& mesh,
                           int threads, Curvature curvature, const Observer& observer)
    : RollingModel(body, on, LoadCase{.angular_speed = angular_speed}, mesh, threads, curvature, observer) {}

RollingModel::RollingModel(const RollingBody& body, const Counterbody& on, const GroundSpeed& speed, const Mesh& mesh,
                           int threads, Curvature curvature, const Observer& observer)
    : RollingModel(body, on, LoadCase{.speed = speed.speed}, mesh, threads, curvature, observer) {}

RollingModel::RollingModel(const RollingBody& body, const Counterbody& on, const LoadCase& speed, const Mesh& mesh,
                           int threads, Curvature curvature, const Observer& observer) {
  const detail::RollingPair pair = detail::rolling_pair(body, on);
  viscoroll::validate(mesh);
  require_speed(speed);
  detail::require_thread_count(threads);
  detail::Watch watch(observer);
  impl_ = detail::with_given_speed(given_speed(speed), [&] {
    const detail::PairAtSpeed at = detail::at_speed(pair, angular_speed_of(speed, *pair.body));
    return std::make_unique<Impl>(detail::make_model(at, mesh, curvature, {threads, watch}));
  });
}

RollingModel::~RollingModel() = default;
RollingModel::RollingModel(RollingModel&&) noexcept = default;
RollingModel& RollingModel::operator=(RollingModel&&) noexcept = default;

Result RollingModel::solve(const LoadCase& load_case, const Options& options) const {
  LoadCase at_speed = checked(load_case, *impl_->model.pair.body);
  validate(options);
  const double speed = impl_->model.pair.angular_speed;
  constexpr double kRoundOff = 1e-12;  // of V / r_o
  if (at_speed.speed && std::abs(at_speed.angular_speed - speed) < kRoundOff * speed) at_speed.angular_speed = speed;
  if (at_speed.angular_speed != speed) {
    throw detail::InvalidSpeed(at_speed.angular_speed, {.before = "the speed of the model, ", .limit = speed})
        .stated_for(given_speed(load_case));
  }
  if (options.mesh && *options.mesh != impl_->model.mesh) {
    detail::reject("mesh", "left out or equal to the mesh of the model", "another mesh");
  }
  detail::Watch watch(options.observer);
  Options own = options;
  own.curvature = impl_->model.curvature;
  return detail::with_given_speed(given_speed(load_case), [&] {
    const detail::RollingCase given = detail::rolling_case(impl_->model.pair, at_speed, own, watch);
    return with_notes(solve_on(impl_->model, given, impl_->faster), given, true);
  });
}

}  // namespace viscoroll
