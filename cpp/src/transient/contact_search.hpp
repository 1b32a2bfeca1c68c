/// @file
/// @brief The contact of an instant, by what there is between the bodies: nothing but pressure, friction, or air.
#pragma once

#include "transient/carried_forces.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/elastic_contact.hpp"
#include "transient/touch.hpp"

namespace viscoroll::detail {

/// @param[in] pair both bodies
/// @param[in] touch place and known displacements
/// @param[in] last forces to start from
/// @param[in] load times what has yielded
/// @param[in,out] inverse of an earlier contact
[[nodiscard]] StickSlip touch_smooth(const CreepingPair& pair, const Touch& touch, const LastForces& last, double load,
                                     ContactInverse& inverse);

/// @brief Where nodes come from in a step with friction.
struct Departure {
  double turned;                 ///< angle by which what rolls turns until its end [rad]
  std::vector<HalfField> borne;  ///< displacement of every body before, of the rows of the window
};

/// @brief The contact of docs/theory/transient-bodies.md, where nodes that met stay matched.
/// @param[in] pair,touch,last as above
/// @param[in] departure where nodes come from
/// @param[in] load [N]
/// @param[in] center what decides how far it comes
/// @param[in,out] stiffness of an earlier contact
[[nodiscard]] StickSlip touch_with_friction(const CreepingPair& pair, const Touch& touch, const LastForces& last,
                                            const Departure& departure, double load, const CenterCondition& center,
                                            ContactStiffness& stiffness);

/// @brief The bodies just touch with what they remember, and bear nothing.
[[nodiscard]] StickSlip touch_lifted(const CreepingPair& pair, const Touch& touch, const CenterCondition& center);

}  // namespace viscoroll::detail
