/// @file
/// @brief Data of a history: two bodies, the phase-shifted meshes and the current instant.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "rolling/contact_estimate.hpp"
#include "transient/shifted_mesh.hpp"
#include "transient/time_step.hpp"
#include "transient/viscoelastic_pair.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll {
namespace detail {

/// @brief Fraction of a motion that is computed.
struct Share {
  double from = 0.0;
  double to = 1.0;
};

/// @brief Meshes on which a step is tried. Their memory is reused for the next step; copies start without it.
struct Trial {
  std::vector<ShiftedMesh> meshes = {};

  Trial() = default;
  Trial(const Trial&) noexcept : Trial() {}
  Trial(Trial&&) noexcept = default;
  Trial& operator=(const Trial&) noexcept { return *this; }
  Trial& operator=(Trial&&) noexcept = default;
  ~Trial() = default;
};

}  // namespace detail

struct RollingHistory::Impl {
  detail::RollingPair at_rest;
  std::vector<detail::BodySpectrum> spectra;
  double inertia = 0.0;  // largest rho r_o^2 / (instantaneous modulus) [s^2]
  HistoryOptions options;
  std::shared_ptr<const detail::ViscoelasticPair> pair;
  std::vector<detail::ShiftedMesh> meshes;
  detail::Trial trial;
  RollingInstant current;
  double contact_stiffness = 0.0;                 // estimate for impacts, if there is an axle [N/m]
  double last_step = 0.0;                         // [s]
  std::optional<detail::StartedSegment> started;  // has begun and not ended
  std::int64_t steps = 0;

  [[nodiscard]] std::shared_ptr<const detail::ViscoelasticPair> with(const detail::TableSize& size,
                                                                     detail::Watch& watch) const {
    return std::make_shared<const detail::ViscoelasticPair>(
        detail::viscoelastic_pair(at_rest, spectra, options, size, watch));
  }

  void enlarge(const detail::TableSize& size, detail::Watch& watch) {
    const auto larger = with(size, watch);
    std::vector<detail::ShiftedMesh> next = meshes;
    detail::parallel_for(
        next.size(), options.threads, watch, "rolling",
        [&](std::size_t l, const detail::Worker& worker) { next[l].widen(larger, worker.checkpoint); });
    pair = larger;
    std::swap(meshes, next);
  }

  void widen(detail::Watch& watch) {
    const Eigen::Index half_nodes = pair->half_nodes();
    if (half_nodes == pair->max_half_nodes()) {
      detail::reject("load", "small enough for the coating",
                     "a load with which the contact extends beyond 60 degrees to either side");
    }
    enlarge({.half_nodes = half_nodes + half_nodes / 2 + 1, .track_reach = pair->track_reach}, watch);
  }

  void lengthen(detail::Watch& watch) {
    const Eigen::Index reach = std::min(2 * pair->track_reach, pair->max_track_reach());
    enlarge({.half_nodes = pair->half_nodes(), .track_reach = reach}, watch);
  }

  /// Run on all meshes. If a contact is too wide or a track too long for the tables, start over on larger tables.
  /// @param[in] fraction completed fraction, same as in `parallel_for`
  template <class Body>
  void on_meshes(detail::Watch& watch, const Body& body, const std::function<double()>& fraction = {}) {
    for (;;) {
      std::vector<detail::ShiftedMesh>& next = trial.meshes;
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
  [[nodiscard]] std::vector<RollingInstant> follow(std::span<const detail::StepEnd> path, detail::Watch& watch,
                                                   const detail::Share& of_motion = {});
  [[nodiscard]] RollingState state() const;
  detail::ContactReach prepare(const RollingBody& body, const Counterbody& on, double load,
                               const std::optional<double>& axle_height, detail::Watch& watch);
  void start(Start start, const detail::StepEnd& first, detail::Watch& watch);
  void create_meshes(const detail::ContactReach& contact, detail::Watch& watch);
  void restore(const RollingState& state, detail::Watch& watch);
  void require_step(const detail::StepEnd& to) const;
  void require_forces(const detail::StepEnd& to) const;
  void require_axle_height(const detail::RollingPair& both, double height) const;
  [[nodiscard]] double turn_of(const detail::StepEnd& begin, const detail::StepEnd& end) const;
  [[nodiscard]] double relative_change(const detail::StepEnd& begin, const detail::StepEnd& end) const;
  [[nodiscard]] double longest_step(const detail::StepEnd& begin, const detail::StepEnd& end) const;
  [[nodiscard]] double max_turn() const {
    return detail::max_turn(pair->nodes.grid.phi_spacing, options.steps_per_spacing);
  }
  [[nodiscard]] std::vector<detail::StepEnd> path_to(const detail::StepEnd& end);
};

}  // namespace viscoroll
