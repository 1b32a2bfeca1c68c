/// @file
/// @brief Influence tables of one of two viscoelastic bodies.
#pragma once

#include "rolling/body.hpp"
#include "transient/creep_tables.hpp"
#include "transient/layer_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Influence tables of elastic layers with relaxed moduli or, for layers with different relaxation functions, of
/// each of their retardation times, including the effect of free side faces.
/// @param[in] at_rest body with relaxed moduli, without inertia; not rigid
/// @param[in] dissimilar_layers its layers if they have different relaxation functions, else null
/// @param[in] kinematics motion of the material at any speed
/// @param[in] shape of the rows
[[nodiscard]] CreepTables tables_of(const Body& at_rest, const LayerSpectrum* dissimilar_layers,
                                    const ContactKinematics& kinematics, const RowShape& shape);

}  // namespace viscoroll::detail
