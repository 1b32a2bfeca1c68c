/// @file
/// @brief What contact, stick and slip ask of a state, docs/theory/friction.md.
#pragma once

#include "contact/stick_slip_system.hpp"

namespace viscoroll::detail {

/// @return what a node does that sticks
[[nodiscard]] TangentialState sticking();

/// @return what a node does that slips, whose direction is that of its traction less what its slip is worth
[[nodiscard]] TangentialState slipping(const StickSlipSystem& system, double friction, const ContactSolution& state,
                                       Eigen::Index node);

/// @brief Who touches, sticks and slips after a state with its gaps and slips; its residual is noted.
/// @param[in] system whose state it is
/// @param[in] friction coefficient
/// @param[in,out] state whose residual is how far all conditions are from holding, as forces, per load
[[nodiscard]] ContactSets find_sets(const StickSlipSystem& system, double friction, ContactSolution& state);

/// @brief Forces between those of coarse nodes make a rough gap, by which much of a contact may seem to lift off. Then
/// the gap and the slip of the coarse mesh, `state.prolonged`, which are used up, tell better who touches.
void keep_contact(const StickSlipSystem& system, double friction, ContactSolution& state, ContactSets& sets);

}  // namespace viscoroll::detail
