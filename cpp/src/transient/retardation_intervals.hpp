/// @file
/// @brief Intervals that contain the retardation times of a layered body at every order of its surface.
#pragma once

#include <span>
#include <vector>

#include "transient/creep_function.hpp"

namespace viscoroll::detail {

/// @brief Intervals of all retardation times of all orders.
///
/// At s = -1/time every modulus is real, and the energy of an order is a sum over the layers, each with the sign of its
/// modulus. The order can be singular, so that a displacement persists without forces, only if two of these signs
/// differ: docs/theory/transient.md.
/// @param[in] moduli moduli of the layers
/// @param[in] has_elastic_part whether part of the energy is positive at all times, as with bulk moduli
/// @return disjoint intervals, ascending; an interval has zero length if all moduli vanish together at a single time
[[nodiscard]] std::vector<TimeRange> retardation_intervals(std::span<const CreepFunction> moduli,
                                                           bool has_elastic_part);

}  // namespace viscoroll::detail
