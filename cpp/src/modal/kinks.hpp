/// @file
/// @brief Detection of kinks in a modulus that a user defines.
#pragma once

#include "viscoroll/materials.hpp"

namespace viscoroll::detail {

/// @brief Find the highest frequency up to which a modulus has kinks, from samples in [low, high].
///
/// Polynomials in the logarithm of the frequency resolve every sum of relaxations in an octave. An octave in which they
/// do not resolve the modulus has a kink.
/// @param[in] modulus any shear modulus
/// @param[in] low,high angular frequencies [rad/s], > 0
/// @return end of the highest octave with a kink [rad/s]; 0 without kinks; `high` if the modulus has no value at a
/// sample
[[nodiscard]] double highest_kink(const ShearModulus& modulus, double low, double high);

}  // namespace viscoroll::detail
