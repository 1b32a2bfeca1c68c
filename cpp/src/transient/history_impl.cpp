// Steps of a history: input checks, the division of segments into steps, and the averages over the meshes.
#include "transient/history_impl.hpp"

#include <atomic>
#include <cmath>
#include <limits>
#include <string>

#include "transient/history_input.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll {

using detail::reject;
using detail::ShiftedMesh;
using detail::StepEnd;
using detail::text;
using Eigen::Index;

/// Check the input; set the creep of both bodies and the mesh. @return estimated extent of the contact at rest
detail::ContactReach RollingHistory::Impl::prepare(const RollingBody& body, const Counterbody& on, double load,
                                                   const std::optional<double>& axle_height, detail::Watch& watch) {
  const detail::RollingPair given = detail::rolling_pair(body, on);
  detail::validate(options);
  detail::require_supported_options(given, options);
  if (!axle_height) detail::require_positive("load", load, given.body->form().load_unit);
  at_rest = detail::rolling_pair(detail::with_relaxed_moduli(body), detail::with_relaxed_moduli(on));
  constexpr double kAnySpeed = 1.0;  // without inertia, it only selects a frequency of moduli that are relaxed here
  detail::ContactReach contact{};
  if (axle_height) {
    require_axle_height(at_rest, *axle_height);
    const double radius = given.body->radius();
    if (!(*axle_height < radius)) {
      reject("axle_height", "< r_o = " + text(radius) + " m at the first instant, so that the bodies touch",
             text(*axle_height) + " m", Range{.unit = "m", .maximum = radius, .excludes_maximum = true});
    }
    detail::PairAtSpeed at_speed;
    static_cast<detail::RollingPair&>(at_speed) = at_rest;
    at_speed.angular_speed = kAnySpeed;
    contact = detail::estimate_contact(at_speed, {.penetration = radius - *axle_height, .angular_speed = kAnySpeed});
  } else {
    contact = detail::estimate_contact(at_rest, kAnySpeed, load);
  }
  if (!options.mesh)
    options.mesh = detail::chosen_mesh(given.body->radius(), contact.along, given.body->form().is_line());
  spectra = detail::creep_spectra(given, options, watch);
  inertia = detail::inertia_of(given, spectra);
  return contact;
}

/// Create tables and meshes, without forces.
void RollingHistory::Impl::create_meshes(const detail::ContactReach& contact, detail::Watch& watch) {
  const detail::Nodes nodes = detail::nodes_of(at_rest, *options.mesh);
  pair = with(detail::first_size(at_rest, *options.mesh, contact), watch);
  const double rows = std::ceil(1.1 * contact.along / (nodes.grid.radius * nodes.grid.phi_spacing)) + 2.0;
  const Index half_rows = std::min(static_cast<Index>(rows), static_cast<Index>(nodes.widest.phi.last));
  for (int l = 0; l < options.averaged_meshes; ++l) {
    meshes.emplace_back(pair, static_cast<double>(l) / options.averaged_meshes, half_rows);
  }
}

/// Solve the first contact on all meshes.
void RollingHistory::Impl::start(Start start, const StepEnd& first, detail::Watch& watch) {
  on_meshes(watch, [&](std::size_t, ShiftedMesh& shifted, const detail::Worker& worker) {
    shifted.start(start, first, options.center_speed, worker.checkpoint);
  });
  std::vector<RollingInstant> instants;
  instants.reserve(meshes.size());
  for (const ShiftedMesh& shifted : meshes) instants.push_back(shifted.current());
  current = mean(instants, first.time);
  if (!options.axle) return;
  // The tangent stiffness of a contact is one to two times P / d; an impact compresses it, with the short-time modulus.
  constexpr double kImpact = 3.0;
  constexpr double kMostStiffening = 10.0;
  const double stiffening = std::min(1.0 / instantaneous(), kMostStiffening);
  contact_stiffness = kImpact * stiffening * current.load / std::abs(current.penetration);
}

RollingInstant RollingHistory::Impl::mean(std::span<const RollingInstant> of_meshes, double time) const {
  RollingInstant mean;
  const auto count = static_cast<double>(of_meshes.size());
  for (const auto member : detail::kShiftedMeshScalars) {
    for (const RollingInstant& one : of_meshes) mean.*member += one.*member / count;
  }
  double variance = 0.0;
  for (const RollingInstant& one : of_meshes) {
    variance += std::pow(one.resisting_torque - mean.resisting_torque, 2) / std::max(count - 1.0, 1.0);
  }
  // Meshes shifted by equal fractions of the spacing cancel harmonics of the staircase, which the estimate does not
  // include: the spread divided by the number of meshes is an empirical bound.
  mean.error_estimate = of_meshes.size() > 1 ? std::sqrt(variance) / count : std::numeric_limits<double>::quiet_NaN();
  mean.time = time;
  if (!detail::approach_exists(pair->pair))
    mean.penetration = mean.axle_height = std::numeric_limits<double>::quiet_NaN();
  return mean;
}

/// Check that the quantities that move the center are complete and consistent.
void RollingHistory::Impl::require_forces(const StepEnd& to) const {
  if (to.center_displacement) {
    detail::require_finite("center_displacement", *to.center_displacement);
    if (options.friction == 0.0) {
      reject("center_displacement", "left out without friction, where it has no effect",
             text(*to.center_displacement) + " m");
    }
    if (options.driving_force != 0.0) {
      reject("driving_force", "0 N if center_displacement is given", text(options.driving_force) + " N");
    }
    if (options.driving_torque) {
      reject("driving_torque", "left out if center_displacement is given", text(*options.driving_torque) + " N m");
    }
    return;
  }
  if (options.driving_force == 0.0 || options.mass > 0.0 || to.axle_height) return;
  if (!(std::abs(options.driving_force) < options.friction * to.load)) {
    const detail::RoundBody& body = *pair->pair.body;
    const std::string unit = " " + std::string(body.form().load_unit);
    reject("driving_force",
           "smaller than friction * load = " + text(options.friction * to.load) + unit +
               " in magnitude, otherwise the " + std::string(body.name()) + " slides permanently",
           text(options.driving_force) + unit);
  }
}

void RollingHistory::Impl::require_axle_height(const detail::RollingPair& both, double height) const {
  detail::require_finite("axle_height", height);
  const auto left_out = [&](bool is_given, const char* why) {
    if (is_given) reject("axle_height", std::string("left out ") + why, text(height) + " m");
  };
  left_out(options.axle.has_value(), "with an axle, whose motion is a result");
  left_out(!detail::approach_exists(both), "in line contact on a half-space, where the penetration is undetermined");
}

void RollingHistory::Impl::require_step(const StepEnd& to) const {
  detail::require_finite("time", to.time);
  detail::require_finite("angle", to.angle);
  const double farthest = detail::kMaxRows * pair->nodes.grid.phi_spacing;
  if (std::abs(to.angle) > farthest)
    reject("angle", "in +-" + detail::rounded(farthest) + " rad", to.angle,
           Range{.unit = "rad", .minimum = -farthest, .maximum = farthest});
  if (!(to.time >= current.time)) {
    reject("time", ">= the current time, " + text(current.time) + " s", text(to.time) + " s",
           Range{.unit = "s", .minimum = current.time});
  }
  if (to.axle_height) {
    require_axle_height(pair->pair, *to.axle_height);
  } else {
    detail::require_nonnegative("load", to.load, pair->pair.body->form().load_unit);
  }
  require_forces(to);
  if (std::abs(to.angle - current.angle) > max_turn()) {
    reject("angle", "within " + detail::rounded(max_turn()) + " rad of the previous angle (ten million steps)",
           to.angle);
  }
  const double duration = to.time - current.time;
  if (duration == 0.0) {
    const bool moves = to.angle != current.angle || to.load != current.axle_force || to.axle_height.has_value() ||
                       to.center_displacement.value_or(current.center_displacement) != current.center_displacement;
    if (moves && instantaneous() == 0.0) {
      reject("time",
             "> the current time, " + text(current.time) +
                 " s, because a coating without instantaneous compliance (KelvinVoigt) cannot jump",
             text(to.time) + " s");
    }
    return;
  }
  constexpr double kNegligible = 0.01;
  const double speed = (to.angle - current.angle) / duration;
  if (inertia * speed * speed > kNegligible) {
    reject("angle",
           "changed so slowly that inertia is negligible, at most " +
               detail::rounded(std::sqrt(kNegligible / inertia)) + " rad/s (or use layers of density 0)",
           detail::rounded(std::abs(speed)) + " rad/s");
  }
}

/// Turn of a segment, or the turn that corresponds to the displacement of a center that passes uneven ground faster.
double RollingHistory::Impl::turn_of(const StepEnd& begin, const StepEnd& end) const {
  const double turn = end.angle - begin.angle;
  if (!end.center_displacement || pair->heights.are_smooth()) return turn;
  const double passed = *end.center_displacement - *begin.center_displacement;
  return std::max(std::abs(turn), std::abs(passed) / pair->nodes.grid.radius);
}

/// Change of the load or, if the height of the axle is given, of the penetration.
double RollingHistory::Impl::relative_change(const StepEnd& begin, const StepEnd& end) const {
  if (!end.axle_height) return detail::relative_change(begin.load, end.load);
  constexpr double kMostSteps = 1e-3;  // limits the steps of an axle that is lifted far
  const double change = std::abs(*end.axle_height - *begin.axle_height);
  const double lower = std::min(*begin.axle_height, *end.axle_height);
  const double deepest = std::max(pair->nodes.grid.radius - lower, kMostSteps * change);
  return change > 0.0 ? change / deepest : 0.0;
}

/// Hundredth of the period in which an axle vibrates on the contact and its spring. Where this would take a large
/// multiple of the steps that rolling takes, the ground changes so slowly that the axle follows without vibrating.
double RollingHistory::Impl::longest_step(const StepEnd& begin, const StepEnd& end) const {
  constexpr double kStepsPerPeriod = 100.0;
  constexpr double kMostPerRollingStep = 16.0;
  constexpr double kMostSteps = 10000.0;
  if (!options.axle || options.axle->mass == 0.0) return std::numeric_limits<double>::infinity();
  const double resolved = detail::vibration_period(*options.axle, contact_stiffness) / kStepsPerPeriod;
  const double rolling =
      std::abs(turn_of(begin, end)) * options.steps_per_spacing.value_or(1) / pair->nodes.grid.phi_spacing;
  return std::max(resolved, (end.time - begin.time) / std::max(kMostPerRollingStep * rolling, kMostSteps));
}

/// Steps to the end of a segment; for a segment that has begun, the remaining steps.
std::vector<StepEnd> RollingHistory::Impl::path_to(const StepEnd& end) {
  if (!started || started->taken == 0 || started->end != end) {
    const double height = detail::approach_exists(pair->pair) ? pair->nodes.grid.radius - current.penetration : 0.0;
    started = detail::StartedSegment{.begin = {.time = current.time,
                                               .angle = current.angle,
                                               .load = current.axle_force,
                                               .center_displacement = current.center_displacement,
                                               .axle_height = height},
                                     .end = end,
                                     .last_step = last_step,
                                     .taken = 0};
  }
  const StepEnd& begin = started->begin;
  double shortest = std::numeric_limits<double>::infinity();
  for (const detail::BodySpectrum& body : spectra) {
    for (const double time : body.spectrum.retardation_times) shortest = std::min(shortest, time);
  }
  const detail::StepChoice choice(pair->nodes.grid.phi_spacing, options.steps_per_spacing, shortest);
  const auto fractions = choice.fractions({.duration = end.time - begin.time,
                                           .turn = turn_of(begin, end),
                                           .relative_load = relative_change(begin, end),
                                           .longest_step = longest_step(begin, end)},
                                          started->last_step);
  std::vector<StepEnd> path;
  path.reserve(fractions.size());
  for (const double fraction : fractions) path.push_back(started->at(fraction));
  path.back() = end;
  const std::size_t taken = std::min(started->taken, path.size() - 1);
  path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(taken));
  return path;
}

std::vector<RollingInstant> RollingHistory::Impl::follow(std::span<const StepEnd> path, detail::Watch& watch,
                                                         const detail::Share& of_motion) {
  const std::size_t count = meshes.size();
  std::vector<RollingInstant> instants(path.size() * count);
  std::vector<detail::PairStep> steps_ahead;
  double before = current.time;
  for (const StepEnd& end : path) {
    detail::PairStep step{.duration = end.time - before, .parts = {}, .contact_stiffness = contact_stiffness};
    for (const detail::BodySpectrum& body : spectra) step.parts.emplace_back(body.spectrum, step.duration);
    steps_ahead.push_back(std::move(step));
    before = end.time;
  }
  std::atomic<std::size_t> done{0};
  const auto fraction = [&] {
    const double of_path = static_cast<double>(done) / static_cast<double>(path.size() * count);
    return std::lerp(of_motion.from, of_motion.to, std::min(of_path, 1.0));  // repeated steps count again
  };
  on_meshes(
      watch,
      [&](std::size_t l, ShiftedMesh& mesh, const detail::Worker& worker) {
        for (std::size_t i = 0; i < path.size(); ++i) {
          mesh.advance(steps_ahead[i], path[i], worker.checkpoint);
          instants[i * count + l] = mesh.current();
          ++done;
          worker.checkpoint();
        }
      },
      fraction);
  std::vector<RollingInstant> means;
  means.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    means.push_back(mean(std::span(instants).subspan(i * count, count), path[i].time));
  }
  last_step = path.back().time - (path.size() > 1 ? path[path.size() - 2].time : current.time);
  steps += static_cast<std::int64_t>(path.size());
  current = means.back();
  started->taken += path.size();
  if (path.back() == started->end) started.reset();
  return means;
}

}  // namespace viscoroll
