/// @file
/// @brief Effect of the contact forces on the center of the rolling body, as rows of coefficients of the nodal forces:
/// see docs/theory/planes-and-pairs.md.
#pragma once

#include <Eigen/Core>
#include <span>

#include "transient/center_motion.hpp"
#include "transient/contact_place.hpp"

namespace viscoroll::detail {

/// @brief Positions at which forces act at an instant.
struct ActingPlaces {
  const ViscoelasticPair& pair;
  const ContactPlace& place;
  /// Displacements of each body in the window, by its components, as in `RowMemory`
  std::span<const HalfField> deformed;
};

/// @return coefficients of Q, the force on the center that balances the nodal forces [-]
[[nodiscard]] VectorField force_on_center(const ActingPlaces& at);

/// @return coefficients of T, the moment of the nodal forces about the center [m]
[[nodiscard]] VectorField moment_about_center(const ActingPlaces& at);

/// @brief Force on the displacement of the center that has the power of Q and of the moment that turns the counterbody.
/// @param[in] at positions of the forces
/// @param[in] penetration of the center [m]
/// @return coefficients of the nodal forces [-]
[[nodiscard]] VectorField force_along_track(const ActingPlaces& at, double penetration);

/// @return slopes of the counterbody's own displacement in the direction in which material passes, forward, down and
/// sideways, at every node [-]; no rows if the counterbody is rigid
[[nodiscard]] VectorField counterbody_slopes(const ActingPlaces& at);

/// @return the condition on the center for forces on half of the nodes, at displaced nodes
[[nodiscard]] CenterRow center_row(const ActingPlaces& at, const CenterCondition& condition);

/// @return whether the condition on the center depends on displacements
[[nodiscard]] bool depends_on_displacements(const ViscoelasticPair& pair, const CenterCondition& condition);

}  // namespace viscoroll::detail
