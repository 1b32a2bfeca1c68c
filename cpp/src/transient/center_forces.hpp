/// @file
/// @brief What the forces of a contact do to the center of what rolls: rows of sums over them,
/// See docs/theory/planes-and-pairs.md.
#pragma once

#include <Eigen/Core>
#include <span>

#include "transient/center_motion.hpp"
#include "transient/contact_place.hpp"

namespace viscoroll::detail {

/// @brief Where forces act at an instant.
struct ActingPlaces {
  const CreepingPair& pair;
  const ContactPlace& place;
  /// Each body's own displacements in the window, by its components, as `RowMemory` has them.
  std::span<const HalfField> deformed;
};

/// @return Q, the force on the center that balances forces at the nodes, for a unit of each [-]
[[nodiscard]] VectorField force_on_center(const ActingPlaces& at);

/// @return T, their moment about the center, for a unit of each [m]
[[nodiscard]] VectorField moment_about_center(const ActingPlaces& at);

/// @return force along the way of the center that takes as much power as Q and what turns the counterpart, for a unit
/// of each [-]
/// @param[in] penetration of the center [m]
[[nodiscard]] VectorField force_along_track(const ActingPlaces& at, double penetration);

/// @return slopes of the counterpart's own displacement along the way of the material, forward, down and sideways, at
/// every node [-]; no rows where it is rigid
[[nodiscard]] VectorField counterpart_slopes(const ActingPlaces& at);

/// @return the condition on the center for forces of a half, at displaced nodes
[[nodiscard]] CenterRow center_row(const ActingPlaces& at, const CenterCondition& condition);

/// @return whether that row depends on displacements
[[nodiscard]] bool depends_on_displacements(const CreepingPair& pair, const CenterCondition& condition);

}  // namespace viscoroll::detail
