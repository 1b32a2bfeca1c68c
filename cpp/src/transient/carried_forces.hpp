/// @file
/// @brief Starting forces: those of the previous contact, moved with the contact.
#pragma once

#include "surface/surface_operator.hpp"
#include "transient/contact_place.hpp"

namespace viscoroll::detail {

/// @brief Forces of the last window.
struct LastForces {
  const VectorField& force;  ///< at the nodes of the contact, row by row
  Eigen::Index count;        ///< number of rows
  double lowest;             ///< position of the middle row relative to the lowest point [spacings]
};

/// @brief Last forces, scaled to a new load; they stay at the lowest point while nodes pass. For a first contact,
/// guessed forces in a window that is a little wider than the contact.
/// @param[in] pair both bodies
/// @param[in] place window
/// @param[in] last last forces; empty for a first contact
/// @param[in] load sum of the forces
[[nodiscard]] VectorField carried_forces(const ViscoelasticPair& pair, const ContactPlace& place,
                                         const LastForces& last, double load);

}  // namespace viscoroll::detail
