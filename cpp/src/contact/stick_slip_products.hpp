/// @file
/// @brief One Newton step of frictional contact by products, for contacts too large for a matrix.
///
/// Unknowns are the pressing forces p of the nodes in contact, the forces t_x and t_z of those that stick, the forces s
/// across the traction mu p e of those that slip, the penetration and the speed ratio. The conditions are those of
/// stick_slip_system.hpp, but that S = 0 is summed up along phi over every run of neighbors that stick: a difference of
/// displacements, whose symbol vanishes for loads alike along phi, becomes the displacement itself, but for that of the
/// node upstream of the run, and the inverse symbol of the compliance preconditions it as well as it does the gaps.
#pragma once

#include "contact/frictional_contact.hpp"
#include "contact/stick_slip_preconditioner.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Solve the conditions linearized at `state` for the new forces, penetration and speed ratio, roughly.
/// @param[in] problem coating, shape, load and drive
/// @param[in] friction mu [-], in place of the problem's
/// @param[in] scales weights of the conditions
/// @param[in] sets nodes in contact and what they do
/// @param[in] preconditioner of the coating on this window
/// @param[in] tolerance of the residual, relative to that of `state`
/// @param[in,out] state forces, penetration and speed ratio are replaced, products counted
void take_newton_step_by_products(const FrictionalContactProblem& problem, double friction,
                                  const ConditionScales& scales, const ContactSets& sets,
                                  const StickSlipPreconditioner& preconditioner, double tolerance,
                                  ContactSolution& state);

}  // namespace viscoroll::detail
