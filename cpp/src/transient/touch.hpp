/// @file
/// @brief Who touches at an instant, and what that displaces in each of two bodies.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "transient/contact_place.hpp"
#include "transient/creeping_pair.hpp"
#include "transient/row_memory.hpp"
#include "transient/stick_slip_step.hpp"

namespace viscoroll::detail {

/// @brief What the new forces displace in each body, once parts of them have yielded.
struct Yielding {
  std::vector<YieldingTables> of_bodies;
  double sum;  ///< of the shares of their tables
};

/// @brief Who touches at an angle, in forces scaled by what has yielded in all bodies.
struct Touch {
  ContactPlace place;
  Yielding yielding;
  std::vector<HalfField> known;  ///< K h of every body
  StickSlip contact;             ///< without friction only with what presses
  /// K p' of every body's every tables, over their reach
  std::vector<std::vector<HalfField>> moved;
  std::function<void()> checkpoint;  ///< to be called every few milliseconds
};

/// @return displacements of all bodies along an axis, against the sense of the forces
/// @param[in] axes,fields of every body
[[nodiscard]] HalfField against(Axis axis, const std::vector<Axes>& axes, const std::vector<HalfField>& fields);

/// @return what all bodies remember, which opens the gap
[[nodiscard]] HalfField known_gap(const CreepingPair& pair, const Touch& touch);

/// @return what the contact does to a body's nodes in the window, by their components
[[nodiscard]] HalfField by_components(const CreepingPair& pair, const Touch& touch, std::size_t body);

/// @brief Find what the forces of a contact displace in each body.
void find_displacements(const CreepingPair& pair, Touch& touch);

/// @return every body's own displacement in the window, all of it
[[nodiscard]] std::vector<HalfField> deformed(const CreepingPair& pair, const Touch& touch);

/// @return what a body comes to bear, and how that displaces it
[[nodiscard]] RowMemory::Load load_of(const CreepingPair& pair, const Touch& touch, std::size_t body);

}  // namespace viscoroll::detail
