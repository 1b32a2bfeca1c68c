/// @file
/// @brief States of stick and slip at a given friction, whatever solves the linear systems: the semismooth Newton
/// iteration of docs/theory/friction.md.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "contact/friction_settings.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief What a state is, and what finding one may take.
struct SearchLimits {
  double tolerance;  ///< residual of a state
  double round_off;  ///< the same where steps no longer halve it
  int free_steps;    ///< that may raise the residual while nodes find their sets
  int most_systems = std::numeric_limits<int>::max();
  double most_products = std::numeric_limits<double>::infinity();
};

/// @brief How steps are taken, and after how many of them an iteration is given up.
struct StepLimits {
  int patience = kFrictionSettings.steps;  ///< that must have halved the residual
  int most = kFrictionSettings.steps;      ///< more than these only as long as they go on to halve it
  bool exact = false;                      ///< where rough steps have failed
};

/// @brief Newton steps on forces, penetration and creepage together, from one state to another.
class SemismoothNewton {
 public:
  /// @param[in,out] system which outlives this object
  /// @param[in] limits of all iterations together
  SemismoothNewton(StickSlipSystem& system, const SearchLimits& limits) : system_(system), limits_(limits) {}

  /// @brief Take another state, with its gaps and slips, for the present one.
  void start_from(ContactSolution state) { state_ = std::move(state); }

  /// @brief Take steps from the present state, at a coefficient of friction that may be infinite.
  /// @return whether they came to a state
  [[nodiscard]] bool iterate(double friction, const StepLimits& limits = {});

  /// @brief Solve for given sets from the present state.
  void take_step(double friction, const ContactSets& sets, double tolerance);

  /// @return the present state, found or not
  [[nodiscard]] const ContactSolution& state() const { return state_; }

  /// @return who touches, sticks and slips after it
  [[nodiscard]] const ContactSets& sets() const { return sets_; }

  /// @return linear systems solved
  [[nodiscard]] int systems() const { return systems_; }

  /// @return whether enough has been tried
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
