/// @file
/// @brief Critical speed, above which rolling radiates waves (docs/theory/inertia.md).
#pragma once

#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Ratio of the Rayleigh wave speed to the shear wave speed.
/// @param[in] shear_ratio b = mu / (lambda + 2 mu), in [0, 3/4)
/// @return c_R / sqrt(mu / rho); 0.955 for an incompressible material (b = 0)
[[nodiscard]] double rayleigh_ratio(double shear_ratio);

/// @brief Lowest speed at which a wave of the undamped layers keeps up with the contact.
/// @param[in] body layers
/// @param[in] highest_frequency frequency at which a `CustomModulus` is evaluated in place of its short-time limit
/// [rad/s]
/// @return Omega [rad/s], for a plane the speed divided by the radius of its metric; infinite without inertia
[[nodiscard]] double critical_speed(const LayeredBody& body, double highest_frequency);

/// @brief Reject a speed at or above the critical speed. For lower speeds the critical speed itself is not computed.
/// @param[in] body layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] highest_frequency frequency at which a `CustomModulus` is evaluated in place of its short-time limit
/// [rad/s]
/// @throws InvalidInput with the critical speed
void require_subcritical(const LayeredBody& body, double angular_speed, double highest_frequency);

/// @brief Reject a speed at which a wave returns around the body with little damping, exp(-pi m tan(delta)).
///
/// The storage moduli at the frequency of order m lose the stiffness of that order. The critical speed does not show
/// this if the short-time modulus is high or infinite but is not reached at the frequencies of rolling.
/// @param[in] body body with its orders in ascending order
/// @throws InvalidInput with the order
void require_damped_waves(const HarmonicBody& body);

}  // namespace viscoroll::detail
