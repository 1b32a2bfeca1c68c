/// @file
/// @brief Up to which speed a body may roll over a plane without radiating waves.
#pragma once

#include "viscoroll/plane.hpp"

namespace viscoroll::detail {

/// @brief Refuse a speed at or above that of the slowest surface wave of the short-time moduli.
/// @param[in] plane layers and base
/// @param[in] speed V [m/s], > 0
/// @param[in] highest_frequency stands for the short-time limit of a `CustomModulus` [rad/s]
/// @throws std::invalid_argument with the critical speed
void require_subcritical(const CoatedPlane& plane, double speed, double highest_frequency);

}  // namespace viscoroll::detail
