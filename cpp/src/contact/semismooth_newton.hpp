/// @file
/// @brief States of stick and slip at a given friction: the semismooth Newton iteration of docs/theory.md section 6.
#pragma once

#include <vector>

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"
#include "contact/friction_settings.hpp"
#include "contact/stick_slip_conditions.hpp"

namespace viscoroll::detail {

/// @brief How steps are taken, and after how many of them an iteration is given up.
struct StepLimits {
  int patience = kFrictionSettings.steps;  ///< that must have halved the residual
  int most = kFrictionSettings.steps;      ///< more than these only as long as they go on to halve it
  bool exact = false;                      ///< where rough steps have failed
};

/// @brief Newton steps on forces, penetration and creepage together, from one state to another.
class SemismoothNewton {
 public:
  /// @param[in] problem which outlives this object; its drive and rigid slip may change from iteration to iteration
  /// @param[in] start without friction, or with friction and its creepage
  /// @param[in] options which outlive this object, too
  SemismoothNewton(const ContactProblem& problem, const ContactSolution& start, const ContactOptions& options);

  /// @brief Take steps from the present state, at a coefficient of friction that may be infinite.
  /// @return whether they came to a state
  [[nodiscard]] bool iterate(double friction, const StepLimits& limits = {});

  /// @return the present state, found or not
  [[nodiscard]] const ContactSolution& state() const { return state_; }

  /// @brief Take another state, with the creepage that the drive gives if it does, but keep count of what was done.
  void restart_from(const ContactSolution& other);

  /// @brief Let what a state leaves of creep come to rest, where it is no start for a finer mesh.
  /// @return the state, with its sets
  [[nodiscard]] ContactSolution finished(double friction);

  /// @return whether enough has been tried
  [[nodiscard]] bool is_exhausted() const;

  /// @return how far the forces of a state are from the condition of the problem's drive [N]
  [[nodiscard]] double drive_excess(const ContactSolution& state) const { return conditions_.drive_excess(state); }

 private:
  [[nodiscard]] bool is_reached(const std::vector<double>& residuals) const;
  [[nodiscard]] bool is_in_vain(const std::vector<double>& residuals, const StepLimits& limits) const;
  [[nodiscard]] ContactSets find_sets(double friction);
  void take_step(double friction, const ContactSets& sets, double tolerance);
  void shorten_step(double friction, const ContactSolution& before);
  void rest(double friction, ContactSets& sets);

  const ContactProblem& problem_;
  const ContactOptions& options_;
  StickSlipConditions conditions_;
  ContactSolution state_;
  int free_steps_;
  double friction_share_;  // of the load, by which residuals are judged
  double tolerance_;       // residual of a state
};

}  // namespace viscoroll::detail
