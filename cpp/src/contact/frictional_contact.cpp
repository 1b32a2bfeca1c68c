#include "contact/frictional_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/validate.hpp"
#include "contact/semismooth_newton.hpp"
#include "contact/stick_slip_by_products.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// A state at a given creepage, and the force by which it misses the condition of the drive [N].
struct CreepageTrial {
  ContactSolution state;
  double excess;
};

/// @param[in] start state from which the search starts
SearchLimits limits_of(const ContactProblem& problem, const ContactSolution& start, const ContactOptions& options) {
  const double share = std::clamp(problem.friction->coefficient, kFrictionSettings.least_friction, 1.0);
  const double affordable = kFrictionSettings.max_operations / problem.surface->operations();
  const double most = std::max(
      affordable, std::min(kFrictionSettings.operator_applications, kFrictionSettings.excess_factor * affordable));
  return {.tolerance = std::max(kFrictionSettings.tolerance * share, options.tolerance),
          .round_off = kFrictionSettings.round_off * share,
          .full_steps = start.creepage ? kFrictionSettings.full_steps_nearby : kFrictionSettings.full_steps,
          .max_systems = options.max_iterations - start.iterations,
          .max_products = most - start.operator_applications};
}

/// Search for the state at the wanted coefficient of friction and drive, from several starting points.
class StateSearch {
 public:
  StateSearch(const ContactProblem& problem, const ContactSolution& start, const ContactOptions& options)
      : wanted_(*problem.friction),
        problem_(problem),
        start_(start),
        limits_(limits_of(problem, start, options)),
        is_start_(options.is_start),
        system_(problem_),
        newton_(system_, limits_) {}

  [[nodiscard]] ContactSolution solve() {
    const bool is_finite = std::isfinite(wanted_.coefficient);
    const bool is_found = (start_.creepage && from_state_with_friction()) || (is_finite ? find() : find_full_stick());
    if (is_found) return finished();
    const int iterations = this->iterations();
    throw ConvergenceError((is_finite ? "no state of stick and slip" : "no state of full stick without tension") +
                               (" was found in " + std::to_string(iterations)) + " iterations: the residual is " +
                               rounded(residual_) + " of the load" +
                               (is_finite ? "" : "; with a finite friction, nodes can slip"),
                           iterations, residual_);
  }

 private:
  /// Number of linear systems, including those of another search whose path to full stick is reused.
  [[nodiscard]] int iterations() const { return start_.iterations + newton_.systems() + shared_systems_; }

  /// Start from a state, with the creepage of the drive if the drive prescribes it.
  void start_from(ContactSolution state) {
    if (const auto given = problem_.friction->drive->given_creepage()) state.creepage = given;
    if (!state.creepage) state.creepage = 0.0;
    system_.find_displacements(state);
    newton_.start_from(std::move(state));
  }

  /// Take Newton steps from the current state to one at the wanted coefficient of friction.
  bool iterate(const StepLimits& limits = {}) {
    const bool is_found = newton_.iterate(wanted_.coefficient, limits);
    const double residual = newton_.state().residual;
    if (problem_.friction->drive == wanted_.drive && residual < kFrictionSettings.divergence_residual)
      residual_ = residual;
    return is_found;
  }

  /// Start from the state of a coarser mesh or smaller box; take accurate steps if rough ones fail.
  bool from_state_with_friction() {
    start_from(start_);
    if (iterate({.patience = kFrictionSettings.patience_nearby})) return true;
    start_from(start_);
    return iterate({.exact = true});
  }

  bool find() { return find_at_once() || (wanted_.drive->given_creepage() ? find_by_friction() : find_by_creepage()); }

  /// Find full stick from the given start. 59 of 76 random cases converged in one iteration; other starting points and
  /// given creepages did not help the rest.
  bool find_full_stick() {
    start_from(start_);
    return iterate();
  }

  /// Full stick need not have a solution, but from it one iteration reaches most coefficients of friction. The
  /// frictionless contact is the start for bodies that slide as a whole.
  bool find_at_once() {
    stick();
    if (iterate()) return true;
    start_from(start_);
    return iterate();
  }

  /// Take the steps to full stick. They do not depend on the wanted coefficient, so another search may have taken them.
  void stick() {
    const bool is_shared = wanted_.shared && problem_.friction->drive == wanted_.drive && !start_.creepage;
    if (is_shared) {
      if (const auto kept = wanted_.shared->stuck()) {
        shared_systems_ += kept->systems;
        shared_products_ += kept->products;
        newton_.start_from(kept->state);
        return;
      }
    }
    const int few = kFrictionSettings.steps_of_full_stick;
    const int products = system_.products();
    SearchLimits limits = limits_;
    limits.tolerance = kFrictionSettings.tolerance;
    limits.round_off = kFrictionSettings.round_off;
    SemismoothNewton sticking(system_, limits);
    start_from(start_);
    sticking.start_from(newton_.state());
    std::ignore = sticking.iterate(std::numeric_limits<double>::infinity(), {.patience = few, .most = few});
    newton_.start_from(sticking.state());
    shared_systems_ += sticking.systems();
    if (!is_shared) return;
    wanted_.shared->keep(
        {.state = sticking.state(), .systems = sticking.systems(), .products = system_.products() - products});
  }

  /// Increase or decrease the coefficient from `easy_friction` to the wanted one by logarithmic steps, halved where
  /// they fail.
  bool find_by_friction() {
    const double ratio = wanted_.coefficient / kFrictionSettings.easy_friction;
    start_from(start_);
    if (!std::isfinite(ratio) || !newton_.iterate(kFrictionSettings.easy_friction)) return false;
    double reached = 0.0;
    for (double step = 1.0; step > kFrictionSettings.shortest_stride && !newton_.is_exhausted();) {
      const ContactSolution before = newton_.state();
      const double next = std::min(reached + step, 1.0);
      if (next == 1.0 ? iterate() : newton_.iterate(kFrictionSettings.easy_friction * std::pow(ratio, next))) {
        if (next == 1.0) return true;
        reached = next;
      } else {
        start_from(before);
        step *= 0.5;
      }
    }
    return false;
  }

  /// Force and moment fall as the creepage rises, from those of a body that spins in place to those of one that skids.
  /// Halve the interval of creepages that contains the drive, and start steps with the drive itself from within it.
  bool find_by_creepage() {
    std::optional<CreepageTrial> near = find_at(0.0, start_);
    if (!near) return false;
    const bool is_above = near->excess > 0.0;
    double here = 0.0;
    double there =
        (is_above ? 1.0 : -1.0) * std::asinh(kFrictionSettings.max_creepage / kFrictionSettings.small_creepage);
    std::optional<CreepageTrial> far = find_at(there, start_);
    if (!far || (far->excess > 0.0) == is_above) return false;
    for (int halving = 0; halving < kFrictionSettings.halvings && !newton_.is_exhausted(); ++halving) {
      if (start_between(*near, *far)) return true;
      const double middle = 0.5 * (here + there);
      std::optional<CreepageTrial> next = find_at(middle, near->state);
      if (!next) return false;
      const bool is_near = (next->excess > 0.0) == is_above;
      (is_near ? here : there) = middle;
      (is_near ? near : far) = std::move(next);
    }
    return false;
  }

  /// Find the state at a given creepage.
  /// @param[in] place asinh(creepage / small_creepage)
  /// @param[in] from start
  std::optional<CreepageTrial> find_at(double place, const ContactSolution& from) {
    problem_.friction->drive = std::make_shared<GivenCreepage>(kFrictionSettings.small_creepage * std::sinh(place));
    start_from(from);
    const bool is_found = (from.creepage && iterate()) || find_at_once() || find_by_friction();
    problem_.friction->drive = wanted_.drive;
    if (!is_found) return std::nullopt;
    return CreepageTrial{newton_.state(), system_.drive_excess(newton_.state())};
  }

  /// Start from the linear interpolation between two states at the point where it satisfies the drive.
  bool start_between(const CreepageTrial& one, const CreepageTrial& other) {
    const double share = one.excess / (one.excess - other.excess);
    ContactSolution between = one.state;
    between.force += share * (other.state.force - one.state.force);
    between.penetration += share * (other.state.penetration - one.state.penetration);
    *between.creepage += share * (*other.state.creepage - *one.state.creepage);
    start_from(between);
    return iterate({.patience = kFrictionSettings.patience_between});
  }

  /// Return the state after further steps that reduce the slip of sticking nodes. This slip may not be small compared
  /// with the differences of displacement between nodes, although the residual is small compared with the load.
  [[nodiscard]] ContactSolution finished() {
    ContactSolution state = newton_.state();
    ContactSets sets = newton_.sets();
    const int most = is_start_ ? 0 : kFrictionSettings.max_slip_reduction_steps;
    for (int step = 0; step < most && system_.creep(state, sets) > kFrictionSettings.largest_creep; ++step) {
      newton_.take_step(wanted_.coefficient, sets, kFrictionSettings.exact_step);
      if (!(newton_.state().residual < state.residual)) break;
      state = newton_.state();
      sets = newton_.sets();
    }
    state.stick.clear();
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      if (sets.states[i].stick) state.stick.push_back(sets.contact[i]);
    }
    state.contact = std::move(sets.contact);
    state.iterations = iterations();
    state.operator_applications = start_.operator_applications + system_.products() + shared_products_;
    state.converged = true;
    return state;
  }

  const Friction& wanted_;
  ContactProblem problem_;  // its drive is replaced during the search
  ContactSolution start_;
  SearchLimits limits_;
  bool is_start_;  // whether another solution starts from this one, so that sticking nodes may still slip
  StickSlipByProducts system_;
  SemismoothNewton newton_;
  int shared_systems_ = 0;   // linear systems on the path to full stick
  int shared_products_ = 0;  // operator applications on that path, if another search took it
  double residual_ = 1.0;    // last finite residual, for the error message
};

}  // namespace

ContactSolution solve_frictional_contact(const ContactProblem& problem, const ContactSolution& start,
                                         const ContactOptions& options) {
  return StateSearch(problem, start, options).solve();
}

}  // namespace viscoroll::detail
