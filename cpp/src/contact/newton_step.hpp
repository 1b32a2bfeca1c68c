/// @file
/// @brief One Newton step of frictional contact: the linear system for given sets of sticking and slipping nodes,
/// solved iteratively.
///
/// Unknowns are the pressing forces p of the nodes in contact, the forces t_x and t_z of the sticking nodes, the forces
/// s of the slipping nodes across their traction mu p e, the penetration and the creepage. The conditions are
///
/// - Contact: gap = 0.
/// - Stick: S = 0, summed along phi over every run of neighboring sticking nodes. The symbol of a difference vanishes
///   for loads that are uniform along phi. The sum is the displacement itself, minus that of the node upstream of the
///   run, so the inverse symbol of the compliance preconditions it as well as the gaps.
/// - Slip: t . e = mu p, and along e', normal to e, (1 - kappa) t . e' + kappa k_t S . e' = 0, which turns e towards
///   -S.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/stick_slip_preconditioner.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Solve the conditions linearized at `state` approximately for new forces, penetration and creepage.
/// @param[in] problem surface, friction and drive
/// @param[in] coefficient coefficient of friction mu [-], used instead of the problem's
/// @param[in] scales weights of the conditions
/// @param[in] sets nodes in contact and their states of stick or slip
/// @param[in] preconditioner preconditioner of the surface on this window
/// @param[in] tolerance residual relative to that of `state`
/// @param[in,out] state forces, penetration and creepage are replaced
/// @return number of operator applications
[[nodiscard]] int take_newton_step(const ContactProblem& problem, double coefficient, const ConditionScales& scales,
                                   const ContactSets& sets, const StickSlipPreconditioner& preconditioner,
                                   double tolerance, ContactSolution& state);

}  // namespace viscoroll::detail
