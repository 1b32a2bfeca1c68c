/// @file
/// @brief Contact at an instant: frictionless, with friction, or lifted off.
#pragma once

#include "transient/carried_forces.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/elastic_contact.hpp"
#include "transient/instant_contact.hpp"

namespace viscoroll::detail {

/// @brief Solve the frictionless contact.
/// @param[in] pair both bodies
/// @param[in] instant place and known displacements
/// @param[in] last starting forces
/// @param[in] load load times the compliance factor `instant.instantaneous.sum`
/// @param[in,out] inverse of an earlier contact
[[nodiscard]] StickSlip solve_frictionless(const ViscoelasticPair& pair, const InstantContact& instant,
                                           const LastForces& last, double load, ContactInverse& inverse);

/// @brief Motion of the nodes before a step with friction ends.
struct Departure {
  double turned;                                ///< angle by which the rolling body turns in the step [rad]
  std::vector<HalfField> loaded_displacements;  ///< earlier displacement of every body, on the rows of the window
};

/// @brief Solve the contact with friction of docs/theory/transient-friction.md, in which nodes that met stay matched.
/// @param[in] pair,instant,last same as in `solve_frictionless`
/// @param[in] departure motion of the nodes in the step
/// @param[in] load [N]
/// @param[in] center condition for the displacement of the center
/// @param[in,out] stiffness of an earlier contact
[[nodiscard]] StickSlip solve_frictional(const ViscoelasticPair& pair, const InstantContact& instant,
                                         const LastForces& last, const Departure& departure, double load,
                                         const CenterCondition& center, ContactStiffness& stiffness);

/// @brief Position of bodies that just touch with their remembered displacements and support no load.
[[nodiscard]] StickSlip solve_lifted(const ViscoelasticPair& pair, const InstantContact& instant,
                                     const CenterCondition& center);

}  // namespace viscoroll::detail
