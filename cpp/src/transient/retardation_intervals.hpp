/// @file
/// @brief Where the retardation times of a layered body lie, at every order of its surface.
#pragma once

#include <span>
#include <vector>

#include "transient/creeping_modulus.hpp"

namespace viscoroll::detail {

/// @brief Intervals of all retardation times of all orders.
///
/// At s = -1/time every modulus is real, and the energy of an order is a sum of the layers' own, each of the sign of
/// its modulus. Only where two of these signs differ can it be singular, so that a displacement goes on without
/// forces: docs/theory/transient.md.
/// @param[in] moduli of the layers
/// @param[in] has_elastic_part whether something else of it is positive at all times, as bulk moduli are
/// @return ascending, apart from each other; one of no length where only there all moduli vanish together
[[nodiscard]] std::vector<TimeRange> retardation_intervals(std::span<const CreepingModulus> moduli,
                                                           bool has_elastic_part);

}  // namespace viscoroll::detail
