/// @file
/// @brief Contact of two viscoelastic bodies at an instant: the search for it (frictionless, with friction, or lifted
/// off), the displacements of both bodies, and the scalar results.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "surface/surface_operator.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/contact_place.hpp"
#include "transient/elastic_contact.hpp"
#include "transient/row_memory.hpp"
#include "transient/stick_slip.hpp"
#include "transient/viscoelastic_pair.hpp"

namespace viscoroll::detail {

/// @brief Compliance of the bodies for the forces at the end of a step.
struct InstantaneousCompliance {
  std::vector<InstantaneousTables> of_bodies;
  double sum;  ///< of the shares of their tables
};

/// @brief Contact at an angle, in forces scaled by the sum of the shares of all bodies.
struct InstantContact {
  ContactPlace place;
  InstantaneousCompliance instantaneous;
  std::vector<HalfField> known;  ///< K h of every body
  StickSlip contact;             ///< without friction, pressing forces only
  /// K p' of every table of every body, over its reach
  std::vector<std::vector<HalfField>> moved;
  std::function<void()> checkpoint;  ///< to be called every few milliseconds
};

/// @brief Forces of the previous contact.
struct LastForces {
  const VectorField& force;  ///< at the nodes of the contact, row by row
  Eigen::Index count;        ///< number of rows
  double lowest;             ///< position of the middle row relative to the lowest point [spacings]
};

/// @brief Solve the frictionless contact.
/// @param[in] pair both bodies
/// @param[in] instant place and known displacements
/// @param[in] last forces of the previous contact, from which the search starts
/// @param[in] condition condition for load and penetration
/// @param[in,out] inverse of an earlier contact
[[nodiscard]] StickSlip solve_frictionless(const ViscoelasticPair& pair, const InstantContact& instant,
                                           const LastForces& last, const ApproachCondition& condition,
                                           ContactInverse& inverse);

/// @brief State from which a step with friction begins.
struct Departure {
  double turned;  ///< angle by which the rolling body turns in the step [rad]
  /// Displacement of every body before the step, on the rows of the window.
  std::vector<HalfField> loaded_displacements;
};

/// @brief Solve the contact with friction of docs/theory/transient-friction.md, in which nodes of the two bodies that
/// met in the contact stay together.
/// @param[in] pair,instant,last same as in `solve_frictionless`
/// @param[in] departure state before the step, and angle turned in it
/// @param[in] condition,inverse same as in `solve_frictionless`
/// @param[in] center condition for the displacement of the center
/// @param[in,out] stiffness of an earlier contact
[[nodiscard]] StickSlip solve_frictional(const ViscoelasticPair& pair, const InstantContact& instant,
                                         const LastForces& last, const Departure& departure,
                                         const ApproachCondition& condition, const CenterCondition& center,
                                         ContactInverse& inverse, ContactStiffness& stiffness);

/// @brief Find the position in which bodies that support no load just touch, with the displacements that remain from
/// earlier loads.
[[nodiscard]] StickSlip solve_lifted(const ViscoelasticPair& pair, const InstantContact& instant,
                                     const CenterCondition& center);

/// @return undeformed gap beyond which no row of uneven surfaces can touch [m]
[[nodiscard]] double limit_of_touch(const ViscoelasticPair& pair, const InstantContact& instant);

/// @brief Compute the displacements due to the forces of a contact in each body.
void find_displacements(const ViscoelasticPair& pair, InstantContact& instant);

/// @return total displacement of every body in the window
[[nodiscard]] std::vector<HalfField> deformed(const ViscoelasticPair& pair, const InstantContact& instant);

/// @return new load of a body, with its displacements
[[nodiscard]] RowMemory::Load load_of(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body);

/// @return area of a flat patch, as used by the half fields [m^2]
[[nodiscard]] double flat_patch(const SurfaceGrid& grid);

/// @brief Set approach, size and pressure of a contact.
/// @param[in] pair both bodies
/// @param[in] instant contact
/// @param[in,out] now instant whose load is set
/// @throws InvalidInput if a coating is compressed by its whole thickness
void set_extent(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now);

/// @brief Forces that do work besides the torque [N].
struct CenterPower {
  double along_track = 0.0;  ///< on the displacement of the center
  /// On the distance by which the center moves farther than the body rolls; the work is dissipated in the counterbody
  /// as its displacement passes
  double creeping = 0.0;
};

/// @brief Set the moments about the center and the force on it. With the vertical compliance, the pressure also does
/// work along the plane, because it displaces the surface in this direction.
/// @param[in] pair both bodies
/// @param[in] instant contact
/// @param[in,out] now instant
/// @return forces that do work besides the torque
[[nodiscard]] CenterPower set_moments(const ViscoelasticPair& pair, const InstantContact& instant, RollingInstant& now);

}  // namespace viscoroll::detail
