#include "contact/semismooth_newton.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "contact/cycle_breaker.hpp"
#include "contact/stick_slip_conditions.hpp"

namespace viscoroll::detail {
namespace {

/// Whether the last residual is at most half of the one `steps` steps earlier.
bool is_halved(const std::vector<double>& residuals, std::size_t steps) {
  return residuals.back() <= 0.5 * residuals[residuals.size() - 1 - steps];
}

/// Interpolate between two states. All fields are linear in the forces, except that slip contains the product of two
/// changes, those of the creepage and of the counterbody's displacement.
void interpolate(const ContactSolution& from, const ContactSolution& to, double share, ContactSolution& between) {
  const auto mix = [share](const auto& one, const auto& other, auto& mixed) { mixed = one + share * (other - one); };
  mix(from.force, to.force, between.force);
  mix(from.gap, to.gap, between.gap);
  mix(from.slip, to.slip, between.slip);
  mix(from.penetration, to.penetration, between.penetration);
  mix(*from.creepage, *to.creepage, *between.creepage);
  if (to.displacement.rows() > 0) mix(from.displacement, to.displacement, between.displacement);
  if (to.counterbody_displacement.rows() > 0) {
    mix(from.counterbody_displacement, to.counterbody_displacement, between.counterbody_displacement);
  }
}

}  // namespace

bool SemismoothNewton::iterate(double friction, const StepLimits& limits) {
  CycleBreaker breaker(state_.force.rows());
  std::vector<double> residuals;
  find_sets(friction);
  if (state_.prolonged) keep_contact(system_, friction, state_, sets_);
  ContactSolution best = state_;
  ContactSets best_sets = sets_;
  for (int step = 0;; ++step) {
    const double start = residuals.empty() ? state_.residual : residuals.front();
    if (!(state_.residual < kFrictionSettings.divergence_residual * std::max(start, 1.0)) || sets_.contact.empty())
      return false;
    residuals.push_back(state_.residual);
    if (is_reached(residuals)) {
      if (state_.displacement.rows() > 0) return true;
      // Gaps and slips are those of the equations; nodes outside the equations have not been checked yet.
      system_.find_displacements(state_);
      find_sets(friction);
      residuals.push_back(state_.residual);
      if (is_reached(residuals)) return true;
      // The residual now contains the error of the equations. Compare later steps with this state, not with earlier
      // residuals, which did not contain that error.
      residuals.erase(residuals.end() - 2);
      best = state_;
      best_sets = sets_;
    }
    if (is_in_vain(residuals, limits)) return false;
    const bool is_full = step < limits_.full_steps;
    if (is_full && state_.residual < best.residual) {
      best = state_;
      best_sets = sets_;
    }
    if (step == limits_.full_steps && state_.residual > kFrictionSettings.max_residual_growth * best.residual) {
      state_ = best;
      sets_ = best_sets;
      residuals.back() = best.residual;
      breaker = CycleBreaker(state_.force.rows());
    }
    const bool released = breaker.release_alternating(sets_, residuals.size() > 2 && is_halved(residuals, 2));
    breaker.stick_reversed(sets_);
    const double tolerance = limits.exact ? kFrictionSettings.exact_step : kFrictionSettings.rough_step;
    if (is_full || released) {
      take_step(friction, sets_, is_full ? tolerance : 0.1 * tolerance);
    } else {
      const ContactSolution before = state_;
      take_step(friction, sets_, 0.1 * tolerance);
      if (!(state_.residual < before.residual)) shorten_step(friction, before);
    }
  }
}

void SemismoothNewton::take_step(double friction, const ContactSets& sets, double tolerance) {
  ++systems_;
  system_.solve(friction, sets, tolerance, state_);
  find_sets(friction);
}

void SemismoothNewton::find_sets(double friction) { sets_ = detail::find_sets(system_, friction, state_); }

bool SemismoothNewton::is_exhausted() const {
  return systems_ >= limits_.max_systems || system_.products() >= limits_.max_products;
}

bool SemismoothNewton::is_reached(const std::vector<double>& residuals) const {
  const bool stalled = residuals.size() > 1 && !is_halved(residuals, 1);
  return state_.residual < limits_.tolerance || (stalled && state_.residual < limits_.round_off);
}

bool SemismoothNewton::is_in_vain(const std::vector<double>& residuals, const StepLimits& limits) const {
  const int step = static_cast<int>(residuals.size()) - 1;
  if (step == kFrictionSettings.max_steps || is_exhausted()) return true;
  const bool progresses = step >= kFrictionSettings.halving && is_halved(residuals, kFrictionSettings.halving);
  if (step >= limits.most && !progresses) return true;
  return step >= limits.patience && !is_halved(residuals, residuals.size() - 1);
}

/// Halve a step that raises the residual, which ends cycles of nodes between two states.
void SemismoothNewton::shorten_step(double friction, const ContactSolution& before) {
  const ContactSolution full = state_;
  for (double share = 0.5; share > kFrictionSettings.shortest_step; share *= 0.5) {
    interpolate(before, full, share, state_);
    find_sets(friction);
    if (state_.residual < before.residual) return;
  }
}

}  // namespace viscoroll::detail
