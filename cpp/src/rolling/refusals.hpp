/// @file
/// @brief What is absurd, or beyond what the method can say: each refused with a message, `std::invalid_argument`.
#pragma once

#include <string>

#include "rolling/assembly.hpp"

namespace viscoroll::detail {

/// @brief Forms of the equations that the bodies have no tables for.
void require_formulation(const MeshModel& model, const Options& options);

/// @brief Loads that no coating of such layers bears.
void require_bearable_load(const MeshModel& model, double load);

/// @brief Steady rolling has gone on for ever: order m = 0 has relaxed, and leaves a groove all around that a modulus
/// of next to nothing cannot bound.
void require_lasting_stiffness(const Assembly& assembly);

/// @brief A window with more nodes than can be held.
/// @throws MeshTooFine
void require_few_nodes(const Window& window, const Mesh& mesh);

/// @brief A penetration [m] through to the core, none at all, and forces of friction that lift what rolls out of its
/// own contact.
/// @param[in] friction with which the contact was solved
/// @throws ConvergenceError where the penetration is no number
void require_contact(const Assembly& assembly, double friction, double penetration);

/// @brief Where no state was found: a driving force or torque out of reach of what slides as a whole.
void require_reachable_drive(const Assembly& assembly, const ContactProblem& problem);

/// @brief The load, always.
/// @param[in] pair both bodies
/// @param[in] load [N], or per length
/// @param[in] reason what becomes of what rolls
[[noreturn]] void reject_load(const RollingPair& pair, double load, const std::string& reason);

/// @brief The load whose contact no window holds, always.
[[noreturn]] void reject_contact_over_60_degrees(const RollingPair& pair, double load);

/// @brief A load that presses what rolls as deep as all layers are thick.
/// @param[in] depth of the free surface [m]
void require_depth(const RollingPair& pair, double load, double depth);

}  // namespace viscoroll::detail
