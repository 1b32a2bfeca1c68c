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
                                                   detail::Watch& watch) {
  const detail::RollingPair given = detail::rolling_pair(body, on);
  detail::validate(options);
  detail::require_supported_options(given, options);
  detail::require_positive("load", load, given.body->form().load_unit);
  at_rest = detail::rolling_pair(detail::with_relaxed_moduli(body), detail::with_relaxed_moduli(on));
  const detail::ContactReach contact = detail::estimate_contact(at_rest, 1.0, load);
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
  if (!detail::approach_exists(pair->pair)) mean.penetration = std::numeric_limits<double>::quiet_NaN();
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
  if (options.driving_force == 0.0 || options.mass > 0.0) return;
  if (!(std::abs(options.driving_force) < options.friction * to.load)) {
    const detail::RoundBody& body = *pair->pair.body;
    const std::string unit = " " + std::string(body.form().load_unit);
    reject("driving_force",
           "smaller than friction * load = " + text(options.friction * to.load) + unit +
               " in magnitude, otherwise the " + std::string(body.name()) + " slides permanently",
           text(options.driving_force) + unit);
  }
}

void RollingHistory::Impl::require_step(const StepEnd& to) const {
  detail::require_finite("time", to.time);
  detail::require_finite("angle", to.angle);
  const double farthest = detail::kMaxRows * pair->nodes.grid.phi_spacing;
  if (std::abs(to.angle) > farthest) reject("angle", "in +-" + detail::rounded(farthest) + " rad", to.angle);
  if (!(to.time >= current.time)) {
    reject("time", ">= the current time, " + text(current.time) + " s", text(to.time) + " s");
  }
  detail::require_nonnegative("load", to.load, pair->pair.body->form().load_unit);
  require_forces(to);
  if (std::abs(to.angle - current.angle) > max_turn()) {
    reject("angle", "within " + detail::rounded(max_turn()) + " rad of the previous angle (ten million steps)",
           to.angle);
  }
  const double duration = to.time - current.time;
  if (duration == 0.0) {
    const bool moves = to.angle != current.angle || to.load != current.load ||
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

/// Steps to the end of a segment; for a segment that has begun, the remaining steps.
std::vector<StepEnd> RollingHistory::Impl::path_to(const StepEnd& end) {
  if (!started || started->taken == 0 || started->end != end) {
    started = detail::StartedSegment{.begin = {.time = current.time,
                                               .angle = current.angle,
                                               .load = current.load,
                                               .center_displacement = current.center_displacement},
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
                                           .turn = end.angle - begin.angle,
                                           .relative_load = detail::relative_change(begin.load, end.load)},
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
    detail::PairStep step{.duration = end.time - before, .parts = {}};
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
