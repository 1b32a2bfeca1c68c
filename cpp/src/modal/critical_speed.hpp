/// @file
/// @brief Where steady rolling without radiated waves ends, theory.md section 7.
#pragma once

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Rayleigh wave speed as a share of the shear wave speed.
/// @param[in] shear_ratio b = mu / (lambda + 2 mu), in [0, 3/4)
/// @return c_R / sqrt(mu / rho), 0.955 where incompressible (b = 0)
[[nodiscard]] double rayleigh_ratio(double shear_ratio);

/// @brief Refuse a rolling speed at or above the critical one, at less than the cost of finding that speed.
/// @param[in] sphere rigid core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] highest_frequency stands for the short-time limit of a `CustomModulus` [rad/s]
/// @throws std::invalid_argument with the critical speed
void require_subcritical(const CoatedSphere& sphere, double angular_speed, double highest_frequency);

}  // namespace viscoroll::detail
