/// @file
/// @brief Response of the coating to one order (m, n) of the two-variable Fourier series (14).
///
/// A field f(r, phi, theta) = sum_mn f_mn(r) exp(i (m phi + n theta)) is steady in space while the material turns, so a
/// material point sees order m at the angular frequency m Omega. Components are ordered (r, phi, theta).
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "viscoroll/observer.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll {

/// @brief 3 x 3 complex matrix in row-major order.
using ComplexMatrix3 = std::array<std::complex<double>, 9>;

/// @brief 6 x 6 complex matrix in row-major order.
using ComplexMatrix6 = std::array<std::complex<double>, 36>;

/// @brief Surface compliance of single orders: displacement d_mn(r_o) [m] per surface stress f_mn(r_o) [Pa], both in
/// the order (r, phi, theta), with the core rigid and inertia in full. Paper equation (31), by a recursion that
/// carries the compliance outwards and so neither overflows nor loses digits (docs/theory/layers.md).
/// @param[in] sphere rigid core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] m orders in phi, any sign
/// @param[in] n orders in theta, any sign, as many as `m`
/// @param[in] curvature sphere or paper: the exact sphere has no orders (m, n)
/// @param[in] observer progress and cancellation
/// @return one matrix for each pair (m, n) [m/Pa]
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] std::vector<ComplexMatrix3> surface_compliance(const CoatedSphere& sphere, double angular_speed,
                                                             std::span<const int> m, std::span<const int> n,
                                                             Curvature curvature = Curvature::sphere,
                                                             const Observer& observer = {});

/// @brief Surface compliance of the exact sphere without inertia, of single degrees l and orders m of the vector
/// spherical harmonics Y, Psi = r grad Y / sqrt(l (l + 1)) and Phi = e_r x Psi: displacement [m] per surface stress
/// [Pa]. See docs/theory/layers.md.
/// @param[in] sphere core and layers, whose densities do not count
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] degree l, >= 0
/// @param[in] order m, any sign, |m| <= l, as many as `degree`
/// @param[in] observer progress and cancellation
/// @return one matrix for each pair (l, m) [m/Pa], in the order (Y, Psi, Phi)
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] std::vector<ComplexMatrix3> degree_compliance(const CoatedSphere& sphere, double angular_speed,
                                                            std::span<const int> degree, std::span<const int> order,
                                                            const Observer& observer = {});

/// @brief Matrix of the system z' = B z in s = ln r, z = (u_r, u_phi, u_theta, r sigma_rr, r sigma_rphi,
/// r sigma_rtheta): paper equation (23) in the form of docs/theory/layers.md, finite at Poisson's ratio 1/2.
/// @param[in] layer the layer that holds the point
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] radius r [m], > 0
/// @param[in] m order in phi
/// @param[in] n order in theta
/// @param[in] curvature sphere or paper
/// @return B, its blocks in the units [-, 1/Pa; Pa, -]
/// @throws std::invalid_argument for bad input
[[nodiscard]] ComplexMatrix6 state_matrix(const Layer& layer, double angular_speed, double radius, int m, int n,
                                          Curvature curvature = Curvature::sphere);

/// @brief Uniform radial displacement of the surface by centrifugal load, paper equation (36): order m = n = 0.
/// @param[in] sphere rigid core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @return d_R^(c) [m], outwards; 0 for incompressible layers
/// @throws std::invalid_argument for bad input
[[nodiscard]] double centrifugal_displacement(const CoatedSphere& sphere, double angular_speed);

/// @brief Lowest rolling speed at which the steady problem of this library ceases to hold: the surface outruns the
/// Rayleigh wave of the outer layer's short-time modulus, or an order of the undamped coating resonates (a soft layer
/// below a stiff one does so earlier). Above it waves are radiated. See docs/theory/inertia.md.
/// @param[in] sphere rigid core and layers
/// @param[in] highest_frequency angular frequency at which a `CustomModulus` stands for its short-time limit [rad/s]
/// @param[in] curvature how much of it the equations keep
/// @return critical Omega [rad/s]; infinite without inertia or where no short-time modulus is finite
/// @throws std::invalid_argument for bad input
[[nodiscard]] double critical_speed(const CoatedSphere& sphere, double highest_frequency = 1e9,
                                    Curvature curvature = Curvature::sphere);

/// @brief Surface compliance of a plane, for waves of single wave numbers: displacement [m] per surface stress [Pa],
/// both along the outward normal, along the way in which material crosses the contact (xi) and across both (zeta), with
/// inertia. See docs/theory/planes-and-pairs.md.
/// @param[in] plane layers and base, not rigid
/// @param[in] speed V at which material crosses the contact [m/s], > 0: a wave has the frequency V k_xi
/// @param[in] k_xi,k_zeta wave numbers [1/m], any sign, as many of each, not both 0
/// @return one matrix for each pair [m/Pa]
/// @throws std::invalid_argument for bad input
[[nodiscard]] std::vector<ComplexMatrix3> surface_compliance(const CoatedPlane& plane, double speed,
                                                             std::span<const double> k_xi,
                                                             std::span<const double> k_zeta);

/// @brief Surface compliance of the tread of a wheel, as if it had no sides, for waves around and across: displacement
/// [m] per surface stress [Pa], both outwards, around (phi) and along the axis (z), with the curvature of the crown
/// that the layers follow and inertia. See docs/theory/wheels.md.
/// @param[in] wheel hub and layers, at least one
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] m orders around, any sign
/// @param[in] k wave numbers across [1/m], any sign, as many as `m`
/// @return one matrix for each pair [m/Pa]
/// @throws std::invalid_argument for bad input
[[nodiscard]] std::vector<ComplexMatrix3> surface_compliance(const CoatedWheel& wheel, double angular_speed,
                                                             std::span<const int> m, std::span<const double> k);

/// @brief Lowest speed at which a wave of the undamped plane keeps up with what rolls over it: the Rayleigh wave of the
/// outer layer, of the base, or a wave of the layers in between.
/// @param[in] plane layers and base
/// @param[in] highest_frequency as for a sphere [rad/s]
/// @return critical speed V [m/s]; infinite without inertia or where no short-time modulus is finite
/// @throws std::invalid_argument for bad input
[[nodiscard]] double critical_speed(const CoatedPlane& plane, double highest_frequency = 1e9);

}  // namespace viscoroll
