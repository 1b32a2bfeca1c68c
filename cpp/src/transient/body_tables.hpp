/// @file
/// @brief The tables of one of two bodies that creep.
#pragma once

#include "rolling/body.hpp"
#include "transient/creeping_tables.hpp"
#include "transient/layer_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Tables of elastic layers at rest or, where layers do not creep alike, of each of their retardation times;
/// with what the sides of a tread add that are free.
/// @param[in] at_rest with every modulus as it is at rest, without inertia; not rigid
/// @param[in] unlike its layers where they do not creep alike, else none
/// @param[in] crossing at any speed
/// @param[in] shape of the rows
[[nodiscard]] CreepingTables tables_of(const Body& at_rest, const LayerSpectrum* unlike, const Crossing& crossing,
                                       const RowShape& shape);

}  // namespace viscoroll::detail
