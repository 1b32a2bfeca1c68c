/// @file
/// @brief Where steady rolling without radiated waves ends, theory.md section 7.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "viscoroll/cylinder.hpp"
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
/// @param[in] curvature how much of it the equations keep
/// @throws std::invalid_argument with the critical speed
void require_subcritical(const CoatedSphere& sphere, double angular_speed, double highest_frequency,
                         Curvature curvature);

/// @brief Refuse a rolling speed at which a wave of some order outruns the surface and comes back around the sphere
/// hardly damped, exp(-pi m tan(delta)): a coating whose short-time modulus is high, or infinite, but plays no role.
/// @param[in] sphere rigid core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] orders m >= 0, from low to high as far as they are looked at
/// @param[in] moduli complex shear moduli, [layer][order]
/// @param[in] curvature how much of it the equations keep
/// @throws std::invalid_argument with the order
void require_damped_waves(const CoatedSphere& sphere, double angular_speed, std::span<const double> orders,
                          const std::vector<std::vector<std::complex<double>>>& moduli, Curvature curvature);

/// @brief The same for a cylinder.
void require_subcritical(const CoatedCylinder& cylinder, double angular_speed, double highest_frequency);
void require_damped_waves(const CoatedCylinder& cylinder, double angular_speed, std::span<const double> orders,
                          const std::vector<std::vector<std::complex<double>>>& moduli);

}  // namespace viscoroll::detail
