/// @file
/// @brief One Newton step of frictional contact: the linear system for given sets of sticking and slipping nodes,
/// solved iteratively.
///
/// The unit vector e is the direction of the traction of a slipping node, and e' is normal to e. S is the slip of a
/// node relative to its upstream neighbor; kappa is `TangentialState::rigidity`, k_t is `ConditionScales::tangential`.
///
/// Unknowns are the normal forces p of the nodes in contact, the tangential forces t_x and t_z of the sticking nodes,
/// the components s = t . e' of the slipping nodes, the penetration and the creepage. The conditions are
///
/// - Contact: gap = 0.
/// - Stick: the sum of S along phi is 0, from the start of a run of neighboring sticking nodes to each node.
///   The sums are used because the symbol of S itself, a difference, vanishes for loads that are uniform along phi. A
///   sum is the displacement of a node minus that of the node upstream of the run. The inverse symbol of the compliance
///   therefore preconditions the sums as well as the gaps.
/// - Slip: t . e = mu p, and (1 - kappa) t . e' + kappa k_t S . e' = 0. The second condition rotates e towards -S.
#pragma once

#include "contact/contact_problem.hpp"
#include "contact/stick_slip_preconditioner.hpp"
#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Solve the conditions, linearized at `state`, for new forces, penetration and creepage, to a tolerance.
/// @param[in] problem surface, friction and drive
/// @param[in] coefficient coefficient of friction mu [-], used instead of the problem's
/// @param[in] scales weights of the conditions
/// @param[in] sets nodes in contact and their states of stick or slip
/// @param[in] preconditioner preconditioner for the surface and its window
/// @param[in] tolerance residual relative to that of `state`
/// @param[in,out] state forces, penetration and creepage are replaced
/// @return number of operator applications
[[nodiscard]] int take_newton_step(const ContactProblem& problem, double coefficient, const ConditionScales& scales,
                                   const ContactSets& sets, const StickSlipPreconditioner& preconditioner,
                                   double tolerance, ContactSolution& state);

}  // namespace viscoroll::detail
