/// @file
/// @brief Where steady rolling without radiated waves ends, docs/theory/inertia.md.
#pragma once

#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Rayleigh wave speed as a share of the shear wave speed.
/// @param[in] shear_ratio b = mu / (lambda + 2 mu), in [0, 3/4)
/// @return c_R / sqrt(mu / rho), 0.955 where incompressible (b = 0)
[[nodiscard]] double rayleigh_ratio(double shear_ratio);

/// @brief Lowest speed at which a wave of the undamped layers keeps up with the contact.
/// @param[in] body layers
/// @param[in] highest_frequency stands for the short-time limit of a `CustomModulus` [rad/s]
/// @return Omega [rad/s], on a plane per radius of its metric; infinite without inertia
[[nodiscard]] double critical_speed(const LayeredBody& body, double highest_frequency);

/// @brief Refuse a speed at or above the critical one, at less than the cost of finding that speed.
/// @param[in] body layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] highest_frequency stands for the short-time limit of a `CustomModulus` [rad/s]
/// @throws std::invalid_argument with the critical speed
void require_subcritical(const LayeredBody& body, double angular_speed, double highest_frequency);

/// @brief Refuse a rolling speed at which a wave of some order outruns the surface and comes back around the body
/// hardly damped, exp(-pi m tan(delta)): a coating whose short-time modulus is high, or infinite, but plays no role.
/// @param[in] body its orders from low to high as far as they are looked at
/// @throws std::invalid_argument with the order
void require_damped_waves(const HarmonicBody& body);

}  // namespace viscoroll::detail
