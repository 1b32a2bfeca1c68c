/// @file
/// @brief One Newton step of frictional contact: the linear system for given sets of sticking and slipping nodes,
/// solved by products.
///
/// Unknowns are the pressing forces p of the nodes in contact, the forces t_x and t_z of those that stick, the forces s
/// across the traction mu p e of those that slip, the penetration and the creepage. Contact: gap = 0. Stick: S = 0,
/// summed up along phi over every run of neighbors that stick: a difference of displacements, whose symbol vanishes for
/// loads alike along phi, becomes the displacement itself, but for that of the node upstream of the run, and the
/// inverse symbol of the compliance preconditions it as well as it does the gaps. Slip: t . e = mu p, and along e',
/// normal to e, (1 - kappa) t . e' + kappa c S . e' = 0, which turns e towards -S.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/stick_slip_preconditioner.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Solve the conditions linearized at `state` for the new forces, penetration and creepage, roughly.
/// @param[in] problem surface, friction and drive
/// @param[in] coefficient mu [-], in place of the problem's
/// @param[in] scales weights of the conditions
/// @param[in] sets nodes in contact and what they do
/// @param[in] preconditioner of the surface on this window
/// @param[in] tolerance of the residual, relative to that of `state`
/// @param[in,out] state forces, penetration and creepage are replaced
/// @return products with the compliance
[[nodiscard]] int take_newton_step(const ContactProblem& problem, double coefficient, const ConditionScales& scales,
                                   const ContactSets& sets, const StickSlipPreconditioner& preconditioner,
                                   double tolerance, ContactSolution& state);

}  // namespace viscoroll::detail
