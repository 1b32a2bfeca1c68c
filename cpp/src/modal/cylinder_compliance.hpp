/// @file
/// @brief The surface compliance of a layered cylinder under tractions that do not vary along its axis.
///
/// Plane strain, theory.md section 14. With ' = d/d ln r, u_phi = i v, stresses times r, s = r sigma_rr and
/// r sigma_rphi = i tau, order m obeys
///
///     u' = a t + (b/mu) s         s'   = -epsilon t + a s + m tau - q ((1 + m^2) u - 2 m v)
///     v' = v - m u + tau/mu       tau' = m (epsilon t - a s) - tau - q ((1 + m^2) v - 2 m u)
///
/// with t = m v - u, epsilon = 4 mu (1 - b) and q = rho Omega^2 r^2. The displacement w along the axis has equations of
/// its own, w' = tau_w/mu and tau_w' = m^2 (mu - q) w.
#pragma once

#include <span>
#include <vector>

#include "modal/line_compliance.hpp"
#include "modal/medium.hpp"
#include "parallel.hpp"
#include "viscoroll/cylinder.hpp"

namespace viscoroll::detail {

/// @brief Carry the compliance from the core outwards, as `surface_compliances` does on a sphere.
/// @param[in] media layers as the order sees them, core outwards; the core is rigid, and displacements are relative to
/// it
/// @param[in] m order >= 0, not necessarily whole
template <class Scalar>
[[nodiscard]] LineCompliance<Scalar> cylinder_compliance(std::span<const Medium<Scalar>> media, double m);

/// @brief Whether an order's static stiffness stays positive through all layers.
[[nodiscard]] bool is_subcritical(std::span<const Medium<double>> media, double m);

/// @return the same layers about a center: what does not depend on the shape is the sphere's
[[nodiscard]] inline CoatedSphere layers_about_center(const CoatedCylinder& cylinder) {
  return {.core_radius = cylinder.core_radius, .layers = cylinder.layers};
}

/// @brief The layers of a cylinder at one order.
/// @param[in] cylinder rigid core and layers, at least one
/// @param[in] moduli complex shear moduli, [layer] [Pa]
/// @param[in] angular_speed Omega [rad/s]
[[nodiscard]] std::vector<Medium<std::complex<double>>> cylinder_media(const CoatedCylinder& cylinder,
                                                                       std::span<const std::complex<double>> moduli,
                                                                       double angular_speed);

/// @brief The surface compliance of a cylinder at a list of orders, whose material sees the frequencies m Omega.
/// @param[in] cylinder rigid core and layers, at least one
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] orders m >= 0, not necessarily whole
/// @param[in] measured_order as for `harmonic_moduli`
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @throws std::invalid_argument for bad input, at a critical speed, and where a modulus is not passive at an order
[[nodiscard]] LineSpectrum cylinder_spectrum(const CoatedCylinder& cylinder, double angular_speed,
                                             const std::vector<double>& orders, double measured_order, int threads,
                                             Watch& watch);

extern template LineCompliance<double> cylinder_compliance(std::span<const Medium<double>>, double);
extern template LineCompliance<std::complex<double>> cylinder_compliance(std::span<const Medium<std::complex<double>>>,
                                                                         double);

}  // namespace viscoroll::detail
