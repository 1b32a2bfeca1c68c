/// @file
/// @brief Checks of inputs that are absurd or outside the validity of the method. Each check throws
/// `InvalidInput`, unless its comment names another exception.
#pragma once

#include <string>

#include "rolling/contact_setup.hpp"

namespace viscoroll::detail {

/// @brief Reject formulations for which the bodies have no tables.
void require_formulation(const RollingPair& pair, const Options& options);

/// @brief Reject penetrations that are too large for the layers or, without adhesion, at which the bodies do not touch.
void require_penetration(const PairAtSpeed& pair, const LoadCase& load_case);

/// @brief Reject loads that no coating of such layers can support, and moduli that relax to almost nothing. In steady
/// state, order m = 0 has relaxed completely: the load leaves a groove around the whole circumference, whose depth such
/// a modulus does not limit. The model comes first because it reports speeds at which both are meaningless.
void require_supported(const MeshModel& model, const RollingCase& given);

/// @brief Reject a window with more nodes than fit into memory.
/// @throws MeshTooFine if the window has too many nodes
void require_node_limit(const Window& window, const Mesh& mesh);

/// @brief Reject a penetration [m] that reaches the core, without adhesion a penetration that is not positive, and
/// friction that lifts the rolling body off its contact.
/// @param[in] setup the load case
/// @param[in] friction coefficient with which the contact was solved
/// @param[in] penetration approach of the bodies [m]
/// @throws ConvergenceError if the penetration is not finite
void require_contact(const ContactSetup& setup, double friction, double penetration);

/// @brief Reject a driving force or torque outside the range of a body that slides as a whole. Called if the solver
/// found no state.
void require_reachable_drive(const ContactSetup& setup, const ContactProblem& problem);

/// @brief Reject the load, or the penetration if that is given, unconditionally.
/// @param[in] pair both bodies
/// @param[in] load_case load case
/// @param[in] reason effect on the rolling body, for the message
[[noreturn]] void reject_load(const RollingPair& pair, const LoadCase& load_case, const std::string& reason);

/// @brief Reject a load or penetration at which adhesion does not keep the bodies together.
/// @param[in] setup load case with adhesion
/// @param[in] load,penetration those of the last state at which they keep together [N], [m]
[[noreturn]] void reject_tension(const ContactSetup& setup, double load, double penetration);

/// @brief Reject a load or penetration whose contact fits into no window.
[[noreturn]] void reject_contact_over_60_degrees(const RollingPair& pair, const LoadCase& load_case);

/// @brief Same for a load [N], or per length.
[[noreturn]] void reject_contact_over_60_degrees(const RollingPair& pair, double load);

/// @brief Reject a load that presses the rolling body deeper than the total thickness of all layers.
/// @param[in] pair both bodies
/// @param[in] load [N], or per length
/// @param[in] depth displacement of the free surface [m]
void require_depth(const RollingPair& pair, double load, double depth);

}  // namespace viscoroll::detail
