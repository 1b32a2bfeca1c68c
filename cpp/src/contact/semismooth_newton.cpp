#include "contact/semismooth_newton.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "contact/cycle_breaker.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr const FrictionSettings& kSettings = kFrictionSettings;

/// Whether the last residual is at most half of that so many steps ago.
bool is_halved(const std::vector<double>& residuals, std::size_t steps) {
  return residuals.back() <= 0.5 * residuals[residuals.size() - 1 - steps];
}

}  // namespace

SemismoothNewton::SemismoothNewton(const ContactProblem& problem, const ContactSolution& start,
                                   const ContactOptions& options)
    : problem_(problem),
      options_(options),
      conditions_(problem),
      state_(start),
      free_steps_(start.creepage ? kSettings.free_steps_nearby : kSettings.free_steps),
      friction_share_(std::clamp(problem.friction->coefficient, kSettings.least_friction, 1.0)),
      tolerance_(std::max(kSettings.tolerance * friction_share_, options.tolerance)) {
  state_.converged = false;
  restart_from(start);
}

bool SemismoothNewton::iterate(double friction, const StepLimits& limits) {
  CycleBreaker breaker(problem_.initial_gap.size());
  std::vector<double> residuals;
  ContactSolution best = state_;
  ContactSets best_sets;
  for (int step = 0;; ++step) {
    ContactSets sets = find_sets(friction);
    if (!(state_.residual < kSettings.hopeless) || sets.contact.empty()) return false;
    residuals.push_back(state_.residual);
    if (is_reached(residuals)) return true;
    if (is_in_vain(residuals, limits)) return false;
    if (step == 0 || state_.residual < best.residual) {
      best = state_;
      best_sets = sets;
    }
    if (step == free_steps_ && state_.residual > kSettings.astray * best.residual) {
      restart_from(best);
      sets = best_sets;
      residuals.back() = best.residual;
      breaker = CycleBreaker(problem_.initial_gap.size());
    }
    const ContactSolution before = state_;
    const bool is_free = step < free_steps_;
    const bool freed = breaker.free_undecided(sets);
    const double tolerance = limits.exact ? kSettings.exact_step : kSettings.rough_step;
    take_step(friction, sets, is_free ? tolerance : 0.1 * tolerance);
    if (!is_free && !freed) shorten_step(friction, before);
  }
}

void SemismoothNewton::restart_from(const ContactSolution& other) {
  const int iterations = state_.iterations;
  const int operator_applications = state_.operator_applications;
  state_ = other;
  state_.iterations = iterations;
  state_.operator_applications = operator_applications;
  if (const auto given = problem_.friction->drive->given_creepage()) state_.creepage = given;
  if (!state_.creepage) state_.creepage = 0.0;
}

ContactSolution SemismoothNewton::finished(double friction) {
  ContactSets sets = conditions_.sets(friction, state_);
  const bool is_a_start = options_.tolerance == tolerance_;  // for a finer mesh
  if (!is_a_start) rest(friction, sets);
  state_.contact = sets.contact;
  state_.stick.clear();
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    if (sets.states[i].stick) state_.stick.push_back(sets.contact[i]);
  }
  state_.converged = true;
  return state_;
}

bool SemismoothNewton::is_exhausted() const {
  const double affordable = kSettings.effort / problem_.surface->operations();
  const double most = std::max(affordable, std::min(kSettings.products, kSettings.costly * affordable));
  return state_.iterations >= options_.max_iterations || state_.operator_applications >= most;
}

bool SemismoothNewton::is_reached(const std::vector<double>& residuals) const {
  const bool stalled = residuals.size() > 1 && !is_halved(residuals, 1);
  return state_.residual < tolerance_ || (stalled && state_.residual < kSettings.round_off * friction_share_);
}

bool SemismoothNewton::is_in_vain(const std::vector<double>& residuals, const StepLimits& limits) const {
  const int step = static_cast<int>(residuals.size()) - 1;
  if (step == kSettings.most_steps || is_exhausted()) return true;
  const bool progresses = step >= kSettings.halving && is_halved(residuals, kSettings.halving);
  if (step >= limits.most && !progresses) return true;
  return step >= limits.patience && !is_halved(residuals, residuals.size() - 1);
}

/// Displacements of the present state, and who touches, sticks and slips after it.
ContactSets SemismoothNewton::find_sets(double friction) {
  conditions_.find_displacements(state_);
  ContactSets sets = conditions_.sets(friction, state_);
  if (state_.prolonged) conditions_.keep_contact(friction, state_, sets);
  return sets;
}

void SemismoothNewton::take_step(double friction, const ContactSets& sets, double tolerance) {
  const bool is_small = static_cast<Index>(sets.contact.size()) <= kSettings.few_nodes;
  ++state_.iterations;
  conditions_.take_step(friction, sets, is_small ? kSettings.exact_step : tolerance, state_);
  if (!problem_.friction->drive->given_creepage()) {
    state_.creepage = std::clamp(*state_.creepage, -kSettings.most_creepage, kSettings.most_creepage);
  }
}

/// Halve a step that leads further away from a solution, which ends cycles of nodes between two states.
void SemismoothNewton::shorten_step(double friction, const ContactSolution& before) {
  const ContactSolution full = state_;
  for (double share = 1.0; share > kSettings.shortest_step; share *= 0.5) {
    state_.force = before.force + share * (full.force - before.force);
    state_.penetration = before.penetration + share * (full.penetration - before.penetration);
    state_.creepage = *before.creepage + share * (*full.creepage - *before.creepage);
    conditions_.find_displacements(state_);
    std::ignore = conditions_.sets(friction, state_);  // for the residual
    if (state_.residual < before.residual) return;
  }
}

/// A residual that is small beside the load may leave creep that is not small beside the way that sticking nodes are
/// carried by the strain of the surface: further steps as long as they help.
void SemismoothNewton::rest(double friction, ContactSets& sets) {
  for (int step = 0; step < kSettings.steps_of_rest; ++step) {
    if (!(conditions_.creep(state_, sets) > kSettings.largest_creep)) return;
    const ContactSolution before = state_;
    ++state_.iterations;
    conditions_.take_step(friction, sets, kSettings.exact_step, state_);
    ContactSets next = find_sets(friction);
    if (!(state_.residual < before.residual)) return restart_from(before);
    sets = std::move(next);
  }
}

}  // namespace viscoroll::detail
