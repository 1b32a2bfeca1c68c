/// @file
/// @brief Contact at an instant, and its displacements in each of two bodies.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "transient/contact_place.hpp"
#include "transient/row_memory.hpp"
#include "transient/stick_slip_step.hpp"
#include "transient/viscoelastic_pair.hpp"

namespace viscoroll::detail {

/// @brief Compliance of the bodies for the new forces.
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

/// @return displacements of all bodies along an axis, opposite to the direction of the forces
/// @param[in] axis direction
/// @param[in] axes,fields of every body
[[nodiscard]] HalfField against(Axis axis, const std::vector<Axes>& axes, const std::vector<HalfField>& fields);

/// @return remembered displacements of all bodies, which open the gap
[[nodiscard]] HalfField known_gap(const ViscoelasticPair& pair, const InstantContact& instant);

/// @return forces of the contact on a body's nodes in the window, by their components
[[nodiscard]] HalfField by_components(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body);

/// @brief Compute the displacements due to the forces of a contact in each body.
void find_displacements(const ViscoelasticPair& pair, InstantContact& instant);

/// @return total displacement of every body in the window
[[nodiscard]] std::vector<HalfField> deformed(const ViscoelasticPair& pair, const InstantContact& instant);

/// @return new load of a body, with its displacements
[[nodiscard]] RowMemory::Load load_of(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body);

}  // namespace viscoroll::detail
