/// @file
/// @brief Conditions of contact, stick and slip (docs/theory/friction.md).
#pragma once

#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @return state of a sticking node
[[nodiscard]] TangentialState sticking();

/// @return state of a slipping node, with the direction of its traction minus its slip times the stiffness
[[nodiscard]] TangentialState slipping(const StickSlipSystem& system, double friction, const ContactSolution& state,
                                       Eigen::Index node);

/// @brief Find the contacting, sticking and slipping nodes that follow from a state with its gaps and slips.
/// @param[in] system system of the state
/// @param[in] friction coefficient of friction
/// @param[in,out] state its residual is set: the norm of all violated conditions, as forces, per load
[[nodiscard]] ContactSets find_sets(const StickSlipSystem& system, double friction, ContactSolution& state);

/// @brief Replace the sets by those of the coarse mesh if interpolated forces keep too little of the contact.
/// Interpolated forces make a rough gap, by which much of a contact may seem to lift off. Gap and slip of the coarse
/// mesh, `state.prolonged`, then give better sets; `state.prolonged` is reset.
void keep_contact(const StickSlipSystem& system, double friction, ContactSolution& state, ContactSets& sets);

}  // namespace viscoroll::detail
