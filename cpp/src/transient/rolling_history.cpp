// Public interface of this folder: checks the input once and averages over the phase-shifted meshes.
#include "viscoroll/rolling_history.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "rolling/contact_estimate.hpp"
#include "transient/creep_spectrum.hpp"
#include "transient/history_input.hpp"
#include "transient/shifted_mesh.hpp"
#include "transient/time_step.hpp"
#include "transient/viscoelastic_pair.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll {
namespace {

using detail::reject;
using detail::ShiftedMesh;
using detail::StepEnd;
using detail::text;
using detail::ViscoelasticPair;
using Eigen::Index;

/// Fraction of a motion that is computed.
struct Share {
  double from = 0.0;
  double to = 1.0;
};

/// Meshes on which a step is tried. Their memory is reused for the next step; copies start without it.
struct Trial {
  std::vector<ShiftedMesh> meshes = {};

  Trial() = default;
  Trial(const Trial&) noexcept : Trial() {}
  Trial(Trial&&) noexcept = default;
  Trial& operator=(const Trial&) noexcept { return *this; }
  Trial& operator=(Trial&&) noexcept = default;
  ~Trial() = default;
};

}  // namespace

struct RollingHistory::Impl {
  detail::RollingPair at_rest;
  std::vector<detail::BodySpectrum> spectra;
  double inertia = 0.0;  // largest rho r_o^2 / (instantaneous modulus) [s^2]
  HistoryOptions options;
  std::shared_ptr<const ViscoelasticPair> pair;
  std::vector<ShiftedMesh> meshes;
  Trial trial;
  RollingInstant current;
  double last_step = 0.0;                         // [s]
  std::optional<detail::StartedSegment> started;  // has begun and not ended
  std::int64_t steps = 0;

  [[nodiscard]] std::shared_ptr<const ViscoelasticPair> with(const detail::TableSize& size,
                                                             detail::Watch& watch) const {
    return std::make_shared<const ViscoelasticPair>(detail::viscoelastic_pair(at_rest, spectra, options, size, watch));
  }

  void enlarge(const detail::TableSize& size, detail::Watch& watch) {
    const auto larger = with(size, watch);
    std::vector<ShiftedMesh> next = meshes;
    detail::parallel_for(
        next.size(), options.threads, watch, "rolling",
        [&](std::size_t l, const detail::Worker& worker) { next[l].widen(larger, worker.checkpoint); });
    pair = larger;
    std::swap(meshes, next);
  }

  void widen(detail::Watch& watch) {
    const Index half_nodes = pair->half_nodes();
    if (half_nodes == pair->max_half_nodes()) {
      reject("load", "small enough for the coating",
             "a load with which the contact extends beyond 60 degrees to either side");
    }
    enlarge({.half_nodes = half_nodes + half_nodes / 2 + 1, .track_reach = pair->track_reach}, watch);
  }

  void lengthen(detail::Watch& watch) {
    const Index reach = std::min(2 * pair->track_reach, pair->max_track_reach());
    enlarge({.half_nodes = pair->half_nodes(), .track_reach = reach}, watch);
  }

  /// Run on all meshes. If a contact is too wide or a track too long for the tables, start over on larger tables.
  /// @param[in] fraction completed fraction, same as in `parallel_for`
  template <class Body>
  void on_meshes(detail::Watch& watch, const Body& body, const std::function<double()>& fraction = {}) {
    for (;;) {
      std::vector<ShiftedMesh>& next = trial.meshes;
      next = meshes;
      try {
        detail::parallel_for(
            next.size(), options.threads, watch, "rolling",
            [&](std::size_t l, const detail::Worker& worker) { body(l, next[l], worker); }, fraction);
        std::swap(meshes, next);
        return;
      } catch (const detail::ContactTooWide&) {
        widen(watch);
      } catch (const detail::TrackTooLong&) {
        lengthen(watch);
      }
    }
  }

  /// Sum over the bodies of the instantaneous compliance relative to the relaxed compliance.
  [[nodiscard]] double instantaneous() const {
    double sum = 0.0;
    for (const detail::BodySpectrum& body : spectra) sum += body.spectrum.instantaneous;
    return sum;
  }

  [[nodiscard]] RollingInstant mean(std::span<const RollingInstant> of_meshes, double time) const;
  [[nodiscard]] std::vector<RollingInstant> follow(std::span<const StepEnd> path, detail::Watch& watch,
                                                   const Share& of_motion = {});
  [[nodiscard]] RollingState state() const;
  detail::ContactReach prepare(const RollingBody& body, const Counterbody& on, double load, detail::Watch& watch);
  void create_meshes(const detail::ContactReach& contact, detail::Watch& watch);
  void restore(const RollingState& state, detail::Watch& watch);
  void require_step(const StepEnd& to) const;
  void require_forces(const StepEnd& to) const;
  [[nodiscard]] double max_turn() const {
    return detail::max_turn(pair->nodes.grid.phi_spacing, options.steps_per_spacing);
  }
  [[nodiscard]] std::vector<StepEnd> path_to(const StepEnd& end);
};

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
  if (std::abs(to.angle) > farthest)
    reject("angle", "in +-" + detail::rounded(farthest) + " rad", to.angle,
           Range{.unit = "rad", .minimum = -farthest, .maximum = farthest});
  if (!(to.time >= current.time)) {
    reject("time", ">= the current time, " + text(current.time) + " s", text(to.time) + " s",
           Range{.unit = "s", .minimum = current.time});
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
                                                         const Share& of_motion) {
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

RollingState RollingHistory::Impl::state() const {
  RollingState state;
  detail::NumberWriter numbers(state.numbers);
  numbers.put(static_cast<double>(pair->half_nodes()));
  numbers.put(static_cast<double>(pair->track_reach));
  numbers.put(static_cast<double>(meshes.size()));
  for (const detail::ViscoelasticBody& body : pair->bodies) {
    numbers.put(body.tables.diagonal_compliance());
    detail::write(body.spectrum, numbers);
  }
  for (const double number : {current.time, last_step, static_cast<double>(steps)}) numbers.put(number);
  detail::write(started, numbers);
  for (const ShiftedMesh& mesh : meshes) mesh.write(numbers);
  return state;
}

void RollingHistory::Impl::restore(const RollingState& state, detail::Watch& watch) {
  constexpr double kSame = 1e-9;
  detail::NumberReader numbers(state.numbers);
  const Index half_nodes = numbers.count(options.mesh->nodes_per_revolution);
  const Index track_reach = numbers.count(static_cast<double>(pair->max_track_reach()));
  if (numbers.count(detail::kMaxAveragedMeshes) != static_cast<Index>(meshes.size())) {
    reject("start", "a state with the same number of averaged meshes (" + std::to_string(meshes.size()) + ")",
           "a state with another number");
  }
  Impl next(*this);
  for (std::size_t b = 0; b < spectra.size(); ++b) {
    const double compliance = numbers.get();
    if (!(std::abs(compliance / pair->bodies[b].tables.diagonal_compliance() - 1.0) < kSame)) {
      reject("start", "a state of the same bodies and mesh", "a state with another compliance");
    }
    next.spectra[b].spectrum = detail::read_spectrum(numbers);
    if (!(detail::difference(next.spectra[b].spectrum, spectra[b].spectrum) <=
          std::max(kSame, 2.0 * options.spectrum_tolerance))) {
      reject("start", "a state of the same materials", "a state with another creep function");
    }
  }
  next.pair = next.with({.half_nodes = half_nodes, .track_reach = track_reach}, watch);
  next.current.time = numbers.get();
  next.last_step = numbers.get();
  next.steps = numbers.count(1e15);
  next.started = detail::read_started_segment(numbers);
  if (next.started) {
    const auto& [begin, end, last_step_before, taken] = *next.started;
    detail::NumberReader::require(begin.time <= next.current.time && next.current.time <= end.time &&
                                  std::abs(end.angle - begin.angle) <= max_turn());
  }
  std::vector<RollingInstant> instants;
  for (std::size_t l = 0; l < meshes.size(); ++l) {
    next.meshes[l] = ShiftedMesh(next.pair, static_cast<double>(l) / static_cast<double>(meshes.size()), 1);
    next.meshes[l].read(numbers, [&watch] { watch.poll("restoring", 0.0); });
    instants.push_back(next.meshes[l].current());
  }
  numbers.finish();
  next.current = next.mean(instants, next.current.time);
  *this = std::move(next);
}

RollingHistory::RollingHistory(const RollingBody& body, double load, Start start, const HistoryOptions& options,
                               double time, double angle, const Observer& observer)
    : RollingHistory(body, CoatedPlane{}, load, start, options, time, angle, observer) {}

RollingHistory::RollingHistory(const RollingBody& body, const Counterbody& on, double load, Start start,
                               const HistoryOptions& options, double time, double angle, const Observer& observer)
    : impl_(std::make_unique<Impl>()) {
  detail::require_finite("time", time);
  detail::require_finite("angle", angle);
  detail::Watch watch(observer);
  Impl& impl = *impl_;
  impl.options = options;
  const detail::ContactReach contact = impl.prepare(body, on, load, watch);
  if (start == Start::undeformed && impl.instantaneous() == 0.0) {
    reject("start", "RELAXED for a coating without instantaneous compliance (KelvinVoigt)", "UNDEFORMED");
  }
  impl.create_meshes(contact, watch);
  const StepEnd first{.time = time, .angle = angle, .load = load, .center_displacement = {}};
  impl.on_meshes(watch, [&](std::size_t, ShiftedMesh& shifted, const detail::Worker& worker) {
    shifted.start(start, first, options.center_speed, worker.checkpoint);
  });
  std::vector<RollingInstant> instants;
  instants.reserve(impl.meshes.size());
  for (const ShiftedMesh& shifted : impl.meshes) instants.push_back(shifted.current());
  impl.current = impl.mean(instants, time);
}

RollingHistory::RollingHistory(const RollingBody& body, const Counterbody& on, double load, const RollingState& state,
                               const HistoryOptions& options, const Observer& observer)
    : impl_(std::make_unique<Impl>()) {
  detail::Watch watch(observer);
  impl_->options = options;
  impl_->create_meshes(impl_->prepare(body, on, load, watch), watch);
  impl_->restore(state, watch);
}

RollingHistory::RollingHistory(const RollingHistory& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
RollingHistory::RollingHistory(RollingHistory&& other) noexcept = default;
RollingHistory& RollingHistory::operator=(const RollingHistory& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
RollingHistory& RollingHistory::operator=(RollingHistory&& other) noexcept = default;
RollingHistory::~RollingHistory() = default;

RollingInstant RollingHistory::advance(double time, double angle, double load,
                                       std::optional<double> center_displacement, const Observer& observer) {
  detail::Watch watch(observer);
  const StepEnd end{.time = time, .angle = angle, .load = load, .center_displacement = center_displacement};
  impl_->require_step(end);
  return impl_->follow(impl_->path_to(end), watch).back();
}

const RollingInstant& RollingHistory::current() const { return impl_->current; }
ContactField RollingHistory::contact() const {
  ContactField field = impl_->meshes.front().field();
  field.time = impl_->current.time;
  return field;
}
std::int64_t RollingHistory::steps() const { return impl_->steps; }
const Mesh& RollingHistory::mesh() const { return *impl_->options.mesh; }
double RollingHistory::spectrum_error() const {
  double largest = 0.0;
  for (const detail::BodySpectrum& body : impl_->spectra) largest = std::max(largest, body.spectrum.error);
  return largest;
}

RollingState RollingHistory::state() const { return impl_->state(); }
void RollingHistory::restore(const RollingState& state, const Observer& observer) {
  detail::Watch watch(observer);
  impl_->restore(state, watch);
}

namespace {

StepEnd waypoint_of(const Motion& motion, std::size_t k) {
  StepEnd waypoint{.time = motion.time[k], .angle = motion.angle[k], .load = motion.load[k], .center_displacement = {}};
  if (!motion.center_displacement.empty()) waypoint.center_displacement = motion.center_displacement[k];
  return waypoint;
}

/// Next waypoint. Of several waypoints at the present time, it is the one after the waypoint that has been reached.
std::size_t next_waypoint(const Motion& motion, const RollingInstant& current) {
  std::size_t next = 0;
  while (motion.time[next] < current.time) ++next;
  for (std::size_t k = next; k < motion.time.size() && motion.time[k] == current.time; ++k) {
    const StepEnd waypoint = waypoint_of(motion, k);
    const bool reached =
        waypoint.center_displacement.value_or(current.center_displacement) == current.center_displacement;
    if (waypoint.angle == current.angle && waypoint.load == current.load && reached) next = k + 1;
  }
  return next;
}

}  // namespace

std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion, const Observer& observer) {
  validate(motion);
  detail::Watch watch(observer);
  RollingHistory::Impl& impl = *history.impl_;
  if (!(impl.current.time >= motion.time.front() && impl.current.time <= motion.time.back())) {
    reject("time", "a list whose range contains the current time, " + text(impl.current.time) + " s",
           text(motion.time.front()) + " s to " + text(motion.time.back()) + " s");
  }
  const auto share_at = [&motion](double time) {
    const double duration = motion.time.back() - motion.time.front();
    return duration > 0.0 ? (time - motion.time.front()) / duration : 1.0;
  };
  std::vector<RollingInstant> instants{impl.current};
  for (std::size_t k = next_waypoint(motion, impl.current); k < motion.time.size(); ++k) {
    const StepEnd end = waypoint_of(motion, k);
    impl.require_step(end);
    const std::vector<StepEnd> path = impl.path_to(end);
    constexpr std::size_t kTogether = 64;
    for (std::size_t first = 0; first < path.size(); first += kTogether) {
      const auto piece = std::span(path).subspan(first, std::min(kTogether, path.size() - first));
      const auto means =
          impl.follow(piece, watch, {.from = share_at(impl.current.time), .to = share_at(piece.back().time)});
      instants.insert(instants.end(), means.begin(), means.end());
    }
  }
  return instants;
}

}  // namespace viscoroll
