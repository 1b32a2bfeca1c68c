/// @file
/// @brief Forces to start from: those of the contact before, where they have been carried to.
#pragma once

#include "surface/surface_operator.hpp"
#include "transient/contact_place.hpp"

namespace viscoroll::detail {

/// @brief Forces of the last window.
struct LastForces {
  const VectorField& force;  ///< of what is below, row by row
  Eigen::Index count;        ///< of its rows
  double lowest;             ///< place of its middle row from the lowest point [spacings]
};

/// @brief The last forces for a new load, which stay below while nodes pass, or those of a first contact, which the
/// window was made a little wider than.
/// @param[in] pair both bodies
/// @param[in] place of the window
/// @param[in] last forces; none of a first contact
/// @param[in] load that they are to bear
[[nodiscard]] VectorField carried_forces(const CreepingPair& pair, const ContactPlace& place, const LastForces& last,
                                         double load);

}  // namespace viscoroll::detail
