/// @file
/// @brief States of stick and slip at a given friction: the semismooth Newton method of docs/theory/friction.md,
/// independent of the solver of its linear systems.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "contact/friction_settings.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Convergence criteria of a state and limits of the search.
struct SearchLimits {
  double tolerance;  ///< residual of a state
  double round_off;  ///< residual of a state if steps no longer halve it
  int full_steps;    ///< number of first steps, which are not shortened if they increase the residual
  int max_systems = std::numeric_limits<int>::max();
  double max_products = std::numeric_limits<double>::infinity();
};

/// @brief Limits of one iteration.
struct StepLimits {
  int patience = kFrictionSettings.steps;  ///< steps after which the residual must have halved
  /// Steps after which the iteration continues only while the residual keeps halving.
  int most = kFrictionSettings.steps;
  bool exact = false;  ///< whether to take accurate steps, after rough ones have failed
};

/// @brief Newton steps on forces, penetration and creepage together.
class SemismoothNewton {
 public:
  /// @param[in,out] system system of equations, which must outlive this object
  /// @param[in] limits limits of all iterations together
  SemismoothNewton(StickSlipSystem& system, const SearchLimits& limits) : system_(system), limits_(limits) {}

  /// @brief Replace the current state by another one, with its gaps and slips.
  void start_from(ContactSolution state) { state_ = std::move(state); }

  /// @brief Take steps from the current state, at a coefficient of friction that may be infinite.
  /// @return whether they converged
  [[nodiscard]] bool iterate(double friction, const StepLimits& limits = {});

  /// @brief Solve for given sets, from the current state.
  void take_step(double friction, const ContactSets& sets, double tolerance);

  /// @return the current state, converged or not
  [[nodiscard]] const ContactSolution& state() const { return state_; }

  /// @return contacting, sticking and slipping nodes that follow from the current state
  [[nodiscard]] const ContactSets& sets() const { return sets_; }

  /// @return number of linear systems solved
  [[nodiscard]] int systems() const { return systems_; }

  /// @return whether the limits of the search are reached
  [[nodiscard]] bool is_exhausted() const;

 private:
  [[nodiscard]] bool is_reached(const std::vector<double>& residuals) const;
  [[nodiscard]] bool is_in_vain(const std::vector<double>& residuals, const StepLimits& limits) const;
  void find_sets(double friction);
  void shorten_step(double friction, const ContactSolution& before);

  StickSlipSystem& system_;
  SearchLimits limits_;
  ContactSolution state_;
  ContactSets sets_;
  int systems_ = 0;
};

}  // namespace viscoroll::detail
