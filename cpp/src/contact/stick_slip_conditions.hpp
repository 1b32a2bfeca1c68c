/// @file
/// @brief What contact, stick and slip ask of a state, docs/theory.md section 6.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/contact_solution.hpp"
#include "contact/newton_step.hpp"
#include "contact/stick_slip_preconditioner.hpp"

namespace viscoroll::detail {

/// @brief The conditions of a problem with friction.
class StickSlipConditions {
 public:
  /// @param[in] problem which outlives this object; its drive may change
  explicit StickSlipConditions(const ContactProblem& problem);

  /// @brief Find displacements, gap and slip from the forces, penetration and creepage of a state.
  void find_displacements(ContactSolution& state) const;

  /// @brief Who touches, sticks and slips after a state with its displacements; its residual is noted.
  /// @param[in] friction coefficient
  [[nodiscard]] ContactSets sets(double friction, ContactSolution& state) const;

  /// @brief Forces between those of coarse nodes make a rough gap, by which much of a contact may seem to lift off.
  /// Then the gap and the slip of the coarse mesh, `state.prolonged`, which are used up, tell better who touches.
  void keep_contact(double friction, ContactSolution& state, ContactSets& sets) const;

  /// @brief Solve the conditions linearized at a state, see `take_newton_step`.
  void take_step(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) const;

  /// @return how far the forces of a state are from the drive's condition [N]
  [[nodiscard]] double drive_excess(const ContactSolution& state) const;

  /// @return largest slip of the nodes that stick, per spread of the ways by which strain moves nodes in contact from
  /// their upstream neighbors
  [[nodiscard]] double creep(const ContactSolution& state, const ContactSets& sets) const;

 private:
  [[nodiscard]] ContactSets classify(double friction, const Eigen::ArrayXd& gap, const Eigen::ArrayX2d& slips,
                                     ContactSolution& state) const;
  [[nodiscard]] double imbalance(const ContactSolution& state) const;

  const ContactProblem& problem_;
  Eigen::Index stride_;  // from a node to its downstream neighbor
  ConditionScales scales_;
  StickSlipPreconditioner preconditioner_;
};

}  // namespace viscoroll::detail
