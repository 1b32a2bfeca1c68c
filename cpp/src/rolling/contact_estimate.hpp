/// @file
/// @brief Size of the contact before anything is solved.
#pragma once

#include "rolling/rolling_pair.hpp"

namespace viscoroll::detail {

/// @brief How far the contact of a pair reaches, rather from above, for the size of the candidate window.
///
/// The load is the sum of Hertz's, P = 8 G a^3 / (3 R), and of the thin bonded layer's, the softer of
/// P = pi G a^6 / (32 R h^3) (incompressible) and P = pi M a^4 / (4 R h) (confined modulus M); the true load at a given
/// a exceeds it, and the softest modulus of all layers is taken. A layer's modulus is the relaxed one, or half of that
/// at the frequency Omega r_o / a of what passes the contact where this is more: a coating that relaxes almost wholly,
/// but not in so short a time, is as stiff as it rolls.
/// Of a roller: P = pi G a^2 / (2 R), 2 G a^5 / (15 R h^3) and 2 M a^3 / (3 R h) per length.
/// Of two bodies, and of layers on a half-space: the compliances, a load's inverse at a given a, add up. Of a groove:
/// the circle with the mean of both curvatures. Of a wheel: strips of its width, each as a roller with the gap that the
/// crown leaves it.
/// @param[in] pair what rolls, and what it rolls on
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] load P [N]
/// @return along and across, of a ball the same a
[[nodiscard]] ContactReach estimate_contact(const RollingPair& pair, double angular_speed, double load);

/// @brief A load that no coating of such layers bears, from above: a thousand times those of Hertz and of the thin
/// incompressible bonded layer for a contact as wide as the body, of the stiffest layer at the highest harmonic.
/// @param[in] pair what rolls, and what it rolls on
/// @param[in] stiffest_modulus the largest shear modulus of a layer at the highest harmonic [Pa]
/// @return load [N], of a roller per length
[[nodiscard]] double unbearable_load(const RollingPair& pair, double stiffest_modulus);

}  // namespace viscoroll::detail
