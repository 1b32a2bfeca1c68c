#include "transient/center_motion.hpp"

#include <cmath>
#include <numbers>

#include "contact/moment_arms.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;

/// Displacement of the nodes of a body along an axis, opposite to the direction of the forces.
ArrayXd displaced(const ActingPlaces& at, std::size_t body, Axis axis) {
  const HalfField& deformed = at.deformed[body];
  const ArrayXd along_axis =
      at.pair.coating().components() == 1
          ? ArrayXd(deformed.reshaped())
          : ArrayXd(along(at.place.axes[body][static_cast<std::size_t>(axis)], deformed).reshaped());
  return along_axis / at.place.weights;
}

ArrayXd slope(const ActingPlaces& at, const ArrayXd& values) {
  const SurfaceGrid& grid = at.pair.nodes.grid;
  return patch_slope(values, at.pair.half_nodes(), grid.radius * grid.phi_spacing);
}

/// Slope of a height of every row, downwards like the slope of a displacement.
ArrayXd slope_of_rows(const ActingPlaces& at, const ArrayXd& rows) {
  if (rows.size() == 0) return ArrayXd::Zero(at.place.moment_arm.size());
  return slope(at, -at_nodes_of_rows(rows, at.pair.half_nodes()));
}

/// Slope of the counterbody's surface, with its height and its displacement, along which the pressure pushes back.
/// Under a rigid body it is the slope of that body's surface.
ArrayXd pushing_slope(const ActingPlaces& at) {
  const auto& bodies = at.pair.bodies;
  const RowHeights& heights = at.place.heights;
  if (bodies.size() > 1) return slope(at, displaced(at, 1, kDown)) + slope_of_rows(at, heights.ground);
  if (bodies.front().rolls) return slope_of_rows(at, heights.ground);
  return at.place.moment_arm / relative_radius(at.pair.pair) - slope_of_rows(at, heights.tread);
}

/// Depth below the center at which tangential forces act.
ArrayXd depth_below_center(const ActingPlaces& at) {
  if (!at.pair.bodies.front().rolls) return at.place.nodes.points().y().values();
  return at.place.nodes.points().y().values() - displaced(at, 0, kDown);
}

/// Coefficients of the time integration of an axle: mass times (1 + lag) a_new - lag a is the force at the end of a
/// step, with Newmark's beta and gamma.
struct AxleIntegration {
  double lag;
  double beta = 0.25 * (1.0 + lag) * (1.0 + lag);
  double gamma = 0.5 + lag;
  double kept = 1.0 - 0.5 / beta;  // part of a in a_new
};

AxleIntegration integration_of(const Axle& axle, const PairStep& step) {
  constexpr double kResolved = 1.0 / 50.0;  // of the period, twice what `RollingHistory::Impl::longest_step` aims at
  return {.lag = step.duration <= kResolved * vibration_period(axle, step.contact_stiffness) ? 0.0 : 1.0};
}

/// Acceleration of a mass by the forces on it after a jump.
void jolt(const Axle& axle, AxleState& state, RollingInstant& now) {
  if (axle.mass == 0.0) return;
  const double spring = axle.stiffness * (now.penetration - state.rest);
  now.axle_acceleration = (now.load - now.axle_force + spring - axle.damping * now.axle_speed) / axle.mass;
  state.acceleration = now.axle_acceleration;
}

}  // namespace

VectorField force_on_center(const ActingPlaces& at) {
  VectorField row = VectorField::Zero(at.place.moment_arm.size(), 3);
  row.col(kForward).setConstant(-1.0);
  row.col(kDown) = at.pair.pair.on->curvatures().along * at.place.moment_arm - pushing_slope(at);
  return row;
}

VectorField moment_about_center(const ActingPlaces& at) {
  const double radius = at.pair.nodes.grid.radius;
  MomentArms arms{.x = radius * (at.place.moment_arm / relative_radius(at.pair.pair) - pushing_slope(at)),
                  .y = ArrayXd::Zero(at.place.moment_arm.size()),
                  .radius = radius};
  if (at.pair.coating().components() > 1) {
    arms.y = depth_below_center(at);
    if (at.pair.compliance == Compliance::vertical) arms.x -= displaced(at, 0, kForward);
  }
  return moment_per_force(arms);
}

VectorField force_along_track(const ActingPlaces& at, double penetration) {
  const double turning = at.pair.pair.on->curvatures().along;
  VectorField row = force_on_center(at);
  if (turning == 0.0) return row;
  row.col(kDown) -= turning * at.place.moment_arm;
  if (!approach_exists(at.pair.pair)) return row;
  row.col(kForward) += turning * (depth_below_center(at) - (at.pair.nodes.grid.radius - penetration));
  return row;
}

VectorField counterbody_slopes(const ActingPlaces& at) {
  const auto& bodies = at.pair.bodies;
  if (bodies.back().rolls) return {};
  VectorField slopes(at.place.moment_arm.size(), 3);
  for (const Axis axis : {kForward, kDown, kSideways}) {
    slopes.col(axis) = -slope(at, displaced(at, bodies.size() - 1, axis));
  }
  return slopes;
}

CenterRow center_row(const ActingPlaces& at, const CenterCondition& condition) {
  CenterRow row{.force_coefficients = VectorField::Zero(at.place.moment_arm.size(), 3),
                .displacement = condition.displacement,
                .value = condition.value};
  if (condition.force != 0.0) row.force_coefficients -= condition.force * force_on_center(at);
  if (condition.torque != 0.0)
    row.force_coefficients += condition.torque / at.pair.nodes.grid.radius * moment_about_center(at);
  row.force_coefficients.colwise() *= at.place.weights;
  return row;
}

bool depends_on_displacements(const ViscoelasticPair& pair, const CenterCondition& condition) {
  return (condition.torque != 0.0 && pair.bodies.front().rolls) || (condition.force != 0.0 && pair.bodies.size() > 1);
}

CenterCondition center_condition(const ViscoelasticPair& pair, const RollingInstant& now, double duration,
                                 const StepEnd& end) {
  if (end.center_displacement)
    return {
        .force = 0.0, .torque = 0.0, .displacement = 1.0, .value = *end.center_displacement - now.center_displacement};
  if (pair.driving_torque) {
    return {.force = 0.0, .torque = 1.0, .displacement = 0.0, .value = *pair.driving_torque / pair.nodes.grid.radius};
  }
  const double mass = pair.mass;
  if (mass == 0.0) return {.force = 1.0, .torque = 0.0, .displacement = 0.0, .value = -pair.driving_force};
  if (duration == 0.0) return {.force = 0.0, .torque = 0.0, .displacement = 1.0, .value = 0.0};
  return {.force = 1.0,
          .torque = 0.0,
          .displacement = -2.0 * mass / (duration * duration),
          .value = -pair.driving_force,
          .coasted = now.center_speed * duration};
}

double vibration_period(const Axle& axle, double contact_stiffness) {
  return 2.0 * std::numbers::pi * std::sqrt(axle.mass / (axle.stiffness + contact_stiffness));
}

ApproachCondition axle_condition(const Axle& axle, const RollingInstant& now, const AxleState& state,
                                 const PairStep& step, double force) {
  const double duration = step.duration;
  const bool is_inert = axle.mass > 0.0 || axle.damping > 0.0;
  if (is_inert && duration == 0.0) return {.force = 0.0, .penetration = 1.0, .value = now.penetration};
  // Downward speed and acceleration, like the penetration.
  const double speed = -now.axle_speed;
  const double acceleration = -state.acceleration;
  const double coasted = now.penetration + speed * duration;
  double stiffness = axle.stiffness;
  double damped = 0.0;
  if (is_inert) {
    // Acceleration and speed at the end of the step are linear in the penetration; these are their values without
    // forces.
    const auto [lag, beta, gamma, kept] = integration_of(axle, step);
    stiffness += (1.0 + lag) * axle.mass / (beta * duration * duration) + gamma * axle.damping / (beta * duration);
    damped = axle.damping * (speed + duration * (1.0 - gamma + gamma * kept) * acceleration);
    damped += axle.mass * ((1.0 + lag) * kept - lag) * acceleration;
  }
  return {.force = 1.0,
          .penetration = stiffness,
          .value = force - damped - axle.stiffness * (coasted - state.rest),
          .coasted = coasted};
}

ApproachCondition scaled(const ApproachCondition& condition, double factor) {
  ApproachCondition result = condition;
  if (condition.force == 0.0) return result;
  result.penetration *= factor;
  result.value *= factor;
  return result;
}

void move_axle(const std::optional<Axle>& axle, const PairStep& step, const RollingInstant& before, AxleState& state,
               RollingInstant& now) {
  const double duration = step.duration;
  const double old = before.axle_speed;
  const double mean_speed = duration > 0.0 ? (before.penetration - now.penetration) / duration : 0.0;
  if (!axle) {
    if (duration == 0.0) return;
    now.axle_acceleration = (mean_speed - old) / duration;
    now.axle_speed = mean_speed;
    return;
  }
  if (duration == 0.0) {
    jolt(*axle, state, now);
  } else {
    const auto [lag, beta, gamma, kept] = integration_of(*axle, step);
    const double acceleration = (mean_speed - old) / (beta * duration) + kept * state.acceleration;
    now.axle_speed += duration * (gamma * acceleration + (1.0 - gamma) * state.acceleration);
    now.axle_acceleration = (1.0 + lag) * acceleration - lag * state.acceleration;
    state.acceleration = acceleration;
  }
  const auto& [mass, stiffness, damping] = *axle;
  const double speed = now.axle_speed;
  now.axle_energy = 0.5 * mass * speed * speed + 0.5 * stiffness * std::pow(now.penetration - state.rest, 2);
  now.dissipated_energy += damping * duration * (old * old + old * speed + speed * speed) / 3.0;
}

void move_center(double mass, double duration, double displacement, double& acceleration, RollingInstant& now) {
  now.center_displacement += displacement;
  if (duration == 0.0) return;
  const double mean_speed = displacement / duration;
  const double before = acceleration;
  if (mass == 0.0) {
    now.center_speed = mean_speed;
    return;
  }
  acceleration = (mean_speed - now.center_speed) / duration + 0.5 * before;
  now.center_speed += duration * (1.5 * acceleration - 0.5 * before);
}

}  // namespace viscoroll::detail
