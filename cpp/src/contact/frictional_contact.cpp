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
  const double tolerance_factor = std::clamp(problem.friction->coefficient, kFrictionSettings.least_friction, 1.0);
  const double affordable_products = kFrictionSettings.max_operations / problem.surface->operations();
  const double max_products = std::max(
      affordable_products,
      std::min(kFrictionSettings.operator_applications, kFrictionSettings.excess_factor * affordable_products));
  return {.tolerance = std::max(kFrictionSettings.tolerance * tolerance_factor, options.tolerance),
          .round_off = kFrictionSettings.round_off * tolerance_factor,
          .full_steps = start.creepage ? kFrictionSettings.full_steps_nearby : kFrictionSettings.full_steps,
          .max_systems = options.max_iterations - start.iterations,
          .max_products = max_products - start.operator_applications};
}

/// Search for the state at the wanted coefficient of friction and drive, from several starting points.
class StateSearch {
 public:
  StateSearch(const ContactProblem& problem, const ContactSolution& start, const ContactOptions& options)
      : wanted_(*problem.friction),
        problem_(problem),
        start_(start),
        limits_(limits_of(problem, start, options)),
        is_intermediate_(options.is_start),
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
  /// Number of linear systems, including those of the steps towards full stick, taken by this search or another one.
  [[nodiscard]] int iterations() const { return start_.iterations + newton_.systems() + systems_towards_full_stick_; }

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

  /// Search from a start with friction, the state on a coarser mesh or in a smaller window. If rough steps fail, take
  /// accurate ones.
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

  /// Iterate from the end of the steps towards full stick, which need not have converged, and if this fails, from the
  /// frictionless contact. The first succeeds for most coefficients of friction, the second for bodies that slide as a
  /// whole.
  bool find_at_once() {
    step_towards_full_stick();
    if (iterate()) return true;
    start_from(start_);
    return iterate();
  }

  /// Take a few steps towards full stick. They do not depend on the wanted coefficient, so another search may have
  /// taken them.
  void step_towards_full_stick() {
    const bool is_shared = wanted_.shared && problem_.friction->drive == wanted_.drive && !start_.creepage;
    if (is_shared) {
      if (const auto kept = wanted_.shared->stuck()) {
        systems_towards_full_stick_ += kept->systems;
        products_of_other_search_ += kept->products;
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
    systems_towards_full_stick_ += sticking.systems();
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

  /// The driving force and the moment decrease with increasing creepage, from those of full sliding in one direction to
  /// those of full sliding in the other. Bisect the interval that contains the creepage at which the condition of the
  /// drive holds. Before each bisection, try Newton steps with this condition, from a state interpolated between the
  /// ends.
  bool find_by_creepage() {
    std::optional<CreepageTrial> first = find_at(0.0, start_);
    if (!first) return false;
    const bool is_above = first->excess > 0.0;
    double first_position = 0.0;
    double second_position =
        (is_above ? 1.0 : -1.0) * std::asinh(kFrictionSettings.max_creepage / kFrictionSettings.small_creepage);
    std::optional<CreepageTrial> second = find_at(second_position, start_);
    if (!second || (second->excess > 0.0) == is_above) return false;
    for (int halving = 0; halving < kFrictionSettings.halvings && !newton_.is_exhausted(); ++halving) {
      if (start_between(*first, *second)) return true;
      const double middle_position = 0.5 * (first_position + second_position);
      std::optional<CreepageTrial> middle = find_at(middle_position, first->state);
      if (!middle) return false;
      const bool replaces_first = (middle->excess > 0.0) == is_above;
      (replaces_first ? first_position : second_position) = middle_position;
      (replaces_first ? first : second) = std::move(middle);
    }
    return false;
  }

  /// Find the state at a given creepage.
  /// @param[in] position asinh(creepage / small_creepage)
  /// @param[in] from start
  std::optional<CreepageTrial> find_at(double position, const ContactSolution& from) {
    problem_.friction->drive = std::make_shared<GivenCreepage>(kFrictionSettings.small_creepage * std::sinh(position));
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

  /// Return the state after further steps that reduce the slip of sticking nodes. Even if the residual is small
  /// compared with the load, this slip can be large compared with the differences of displacement between neighboring
  /// nodes.
  [[nodiscard]] ContactSolution finished() {
    ContactSolution state = newton_.state();
    ContactSets sets = newton_.sets();
    const int most = is_intermediate_ ? 0 : kFrictionSettings.max_slip_reduction_steps;
    for (int step = 0;
         step < most && system_.slip_of_sticking_nodes(state, sets) > kFrictionSettings.max_slip_of_sticking_nodes;
         ++step) {
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
    state.operator_applications = start_.operator_applications + system_.products() + products_of_other_search_;
    state.converged = true;
    return state;
  }

  const Friction& wanted_;
  ContactProblem problem_;  // its drive is replaced during the search
  ContactSolution start_;
  SearchLimits limits_;
  bool is_intermediate_;  // whether another search starts from the result, so that sticking nodes may still slip
  StickSlipByProducts system_;
  SemismoothNewton newton_;
  int systems_towards_full_stick_ = 0;  // linear systems of the steps towards full stick
  int products_of_other_search_ = 0;    // operator applications of these steps, if another search took them
  /// residual of the last iteration with the wanted drive that did not diverge, for the error message
  double residual_ = 1.0;
};

}  // namespace

ContactSolution solve_frictional_contact(const ContactProblem& problem, const ContactSolution& start,
                                         const ContactOptions& options) {
  return StateSearch(problem, start, options).solve();
}

}  // namespace viscoroll::detail
