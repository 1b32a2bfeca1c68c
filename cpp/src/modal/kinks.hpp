/// @file
/// @brief Where a modulus that somebody else defines is smooth.
#pragma once

#include "viscoroll/materials.hpp"

namespace viscoroll::detail {

/// @brief How far kinks of a modulus reach, as far as samples of [low, high] show: in each octave polynomials in the
/// logarithm of the frequency must resolve it, as they do any sum of relaxations.
/// @param[in] modulus any shear modulus
/// @param[in] low,high angular frequencies [rad/s], > 0
/// @return end of the highest octave where they do not [rad/s], 0 where there is none, `high` where it has no value
[[nodiscard]] double highest_kink(const ShearModulus& modulus, double low, double high);

}  // namespace viscoroll::detail
