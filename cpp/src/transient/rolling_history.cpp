// Public interface of this folder: histories, and motions between waypoints.
#include "viscoroll/rolling_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "transient/history_impl.hpp"
#include "transient/history_input.hpp"

namespace viscoroll {

using detail::reject;
using detail::ShiftedMesh;
using detail::StepEnd;
using detail::text;

RollingHistory::RollingHistory(const RollingBody& body, double load, Start start, const HistoryOptions& options,
                               double time, double angle, const Observer& observer)
    : RollingHistory(body, CoatedPlane{}, load, start, options, time, angle, observer) {}

RollingHistory::RollingHistory(const RollingBody& body, const Counterbody& on, double load, Start start,
                               const HistoryOptions& options, double time, double angle, const Observer& observer,
                               std::optional<double> axle_height)
    : impl_(std::make_unique<Impl>()) {
  detail::require_finite("time", time);
  detail::require_finite("angle", angle);
  detail::Watch watch(observer);
  Impl& impl = *impl_;
  impl.options = options;
  const detail::ContactReach contact = impl.prepare(body, on, load, axle_height, watch);
  if (start == Start::undeformed && impl.instantaneous() == 0.0) {
    reject("start", "RELAXED for a coating without instantaneous compliance (KelvinVoigt)", "UNDEFORMED");
  }
  impl.create_meshes(contact, watch);
  impl.start(start, {.time = time, .angle = angle, .load = load, .center_displacement = {}, .axle_height = axle_height},
             watch);
}

RollingHistory::RollingHistory(const RollingBody& body, const Counterbody& on, double load, const RollingState& state,
                               const HistoryOptions& options, const Observer& observer,
                               std::optional<double> axle_height)
    : impl_(std::make_unique<Impl>()) {
  detail::Watch watch(observer);
  impl_->options = options;
  impl_->create_meshes(impl_->prepare(body, on, load, axle_height, watch), watch);
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
                                       std::optional<double> center_displacement, const Observer& observer,
                                       std::optional<double> axle_height) {
  detail::Watch watch(observer);
  const StepEnd end{.time = time,
                    .angle = angle,
                    .load = load,
                    .center_displacement = center_displacement,
                    .axle_height = axle_height};
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
  StepEnd waypoint{.time = motion.time[k], .angle = motion.angle[k], .load = 0.0, .center_displacement = {}};
  if (!motion.load.empty()) waypoint.load = motion.load[k];
  if (!motion.axle_height.empty()) waypoint.axle_height = motion.axle_height[k];
  if (!motion.center_displacement.empty()) waypoint.center_displacement = motion.center_displacement[k];
  return waypoint;
}

/// Next waypoint. Of several waypoints at the present time, it is the one after the waypoint that has been reached.
std::size_t next_waypoint(const Motion& motion, const RollingInstant& current, double radius) {
  // Heights follow from penetrations, and displacements of the center are sums over the steps.
  constexpr double kRoundOff = 1e-12;  // relative to the radius
  const auto equal = [radius](double one, double other) { return std::abs(one - other) <= kRoundOff * radius; };
  std::size_t next = 0;
  while (motion.time[next] < current.time) ++next;
  for (std::size_t k = next; k < motion.time.size() && motion.time[k] == current.time; ++k) {
    const StepEnd waypoint = waypoint_of(motion, k);
    const bool reached =
        equal(waypoint.center_displacement.value_or(current.center_displacement), current.center_displacement);
    const bool supported = waypoint.axle_height ? equal(*waypoint.axle_height, radius - current.penetration)
                                                : waypoint.load == current.axle_force;
    if (waypoint.angle == current.angle && supported && reached) next = k + 1;
  }
  return next;
}

}  // namespace

Motion motion_of(const Oscillation& oscillation) {
  detail::require_in({.unit = "Hz", .minimum = 1e-100, .maximum = 1e100}, "frequency", oscillation.frequency);
  detail::require_in({.minimum = 0.0, .maximum = 1e4, .excludes_minimum = true}, "cycles", oscillation.cycles);
  detail::require_finite("amplitude", oscillation.amplitude);
  constexpr double kWaypointsPerCycle = 160.0;
  const auto count = static_cast<std::size_t>(std::max(kWaypointsPerCycle * oscillation.cycles, 1.0));
  Motion motion;
  for (std::size_t k = 0; k <= count; ++k) {
    const double time =
        oscillation.cycles / oscillation.frequency * static_cast<double>(k) / static_cast<double>(count);
    motion.time.push_back(time);
    motion.angle.push_back(oscillation.amplitude * std::sin(2.0 * std::numbers::pi * oscillation.frequency * time));
  }
  return motion;
}

TimeRange time_range(const Motion& motion, const std::optional<Mesh>& mesh, std::optional<int> steps_per_spacing) {
  constexpr double kTypicalNodes = 500.0;
  const double spacing = mesh ? phi_spacing(*mesh) : 2.0 * std::numbers::pi / kTypicalNodes;
  const double step = spacing / steps_per_spacing.value_or(1);
  const double duration = std::max(motion.time.back() - motion.time.front(), 1e-9);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < motion.time.size(); ++k) {
    const double turn = std::abs(motion.angle[k] - motion.angle[k - 1]);
    const double time = motion.time[k] - motion.time[k - 1];
    if (turn > 0.0 && time > 0.0) shortest = std::min(shortest, 0.1 * step * time / turn);
  }
  if (std::isinf(shortest)) shortest = 1e-4 * duration;
  return {.shortest = std::min(shortest, 0.1 * duration), .longest = 10.0 * duration};
}

std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion, const Observer& observer,
                                 const InstantReceiver& receive) {
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
  for (std::size_t k = next_waypoint(motion, impl.current, impl.pair->nodes.grid.radius); k < motion.time.size(); ++k) {
    const StepEnd end = waypoint_of(motion, k);
    impl.require_step(end);
    const std::vector<StepEnd> path = impl.path_to(end);
    const std::size_t together = receive ? 8 : 64;
    for (std::size_t first = 0; first < path.size(); first += together) {
      const auto piece = std::span(path).subspan(first, std::min(together, path.size() - first));
      const auto means =
          impl.follow(piece, watch, {.from = share_at(impl.current.time), .to = share_at(piece.back().time)});
      instants.insert(instants.end(), means.begin(), means.end());
      if (receive) receive(means);
    }
  }
  return instants;
}

}  // namespace viscoroll
