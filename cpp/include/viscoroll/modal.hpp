/// @file
/// @brief Response of the layers to single orders (m, n) of the two-variable Fourier series, equation (14) of the
/// paper.
///
/// A field f(r, phi, theta) = sum_mn f_mn(r) exp(i (m phi + n theta)) is steady in space while the material turns, so
/// that order m oscillates in the material at the angular frequency m Omega. Components are in the order (r, phi,
/// theta).
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

/// @brief Surface compliance of single orders of a sphere: displacement [m] per stress [Pa] at the outer radius r_o.
///
/// Both vectors are in the order (r, phi, theta). The compliance is that of equation (31) of the paper, with all
/// inertial terms. A recursion carries it outwards from the core without overflow or loss of digits
/// (docs/theory/layers.md).
/// @param[in] sphere core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] m orders in phi, any sign
/// @param[in] n orders in theta, any sign, as many as `m`
/// @param[in] curvature `sphere` or `paper`; the exact sphere has no orders (m, n)
/// @param[in] observer progress and cancellation
/// @return one matrix for each pair (m, n) [m/Pa]
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] std::vector<ComplexMatrix3> surface_compliance(const CoatedSphere& sphere, double angular_speed,
                                                             std::span<const int> m, std::span<const int> n,
                                                             Curvature curvature = Curvature::sphere,
                                                             const Observer& observer = {});

/// @brief Surface compliance of single vector spherical harmonics of the exact sphere, without inertia: displacement
/// [m] per surface stress [Pa].
///
/// The harmonics of degree l and order m are Y, Psi = r grad Y / sqrt(l (l + 1)) and Phi = e_r x Psi. See
/// docs/theory/layers.md.
/// @param[in] sphere core and layers; their densities have no effect
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] degree degrees l >= 0
/// @param[in] order orders m, any sign, |m| <= l, as many as `degree`
/// @param[in] observer progress and cancellation
/// @return one matrix for each pair (l, m) [m/Pa], in the order (Y, Psi, Phi)
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] std::vector<ComplexMatrix3> degree_compliance(const CoatedSphere& sphere, double angular_speed,
                                                            std::span<const int> degree, std::span<const int> order,
                                                            const Observer& observer = {});

/// @brief Matrix B of the layer equations z' = B z.
///
/// The derivative is with respect to s = ln r, and z = (u_r, u_phi, u_theta, r sigma_rr, r sigma_rphi, r sigma_rtheta).
/// This is equation (23) of the paper in the form of docs/theory/layers.md, which is finite at Poisson's ratio 1/2.
/// @param[in] layer layer that contains the point
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] radius r [m], > 0
/// @param[in] m order in phi
/// @param[in] n order in theta
/// @param[in] curvature `sphere` or `paper`
/// @return B; the units of its blocks are [-, 1/Pa; Pa, -]
/// @throws InvalidInput for invalid input
[[nodiscard]] ComplexMatrix6 state_matrix(const Layer& layer, double angular_speed, double radius, int m, int n,
                                          Curvature curvature = Curvature::sphere);

/// @brief Uniform radial displacement of the surface under the centrifugal load, order m = n = 0 of equation (36) of
/// the paper.
/// @param[in] sphere core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @return d_R^(c) [m], outwards; 0 for incompressible layers on a rigid core
/// @throws InvalidInput for invalid input
[[nodiscard]] double centrifugal_displacement(const CoatedSphere& sphere, double angular_speed);

/// @brief Critical angular speed of a sphere: the lowest Omega at which a surface wave keeps up with the contact.
///
/// It is the lower of two limits: r_o Omega is the speed of Rayleigh waves in the outer layer, with its short-time
/// modulus, or an order of the undamped layers resonates. The second is the lower one if a soft layer lies below a
/// stiff one. Above the critical speed waves are radiated, which the steady problem of this library excludes. See
/// docs/theory/inertia.md.
/// @param[in] sphere core and layers
/// @param[in] highest_frequency angular frequency whose modulus is taken as the short-time limit of a
/// `CustomModulus` [rad/s]
/// @param[in] curvature curvature terms in the layer equations
/// @return critical Omega [rad/s]; infinite without inertia, or if no short-time modulus is finite
/// @throws InvalidInput for invalid input
[[nodiscard]] double critical_speed(const CoatedSphere& sphere, double highest_frequency = 1e9,
                                    Curvature curvature = Curvature::sphere);

/// @brief Surface compliance of a plane for waves of single wave numbers, with inertia: displacement [m] per surface
/// stress [Pa].
///
/// The directions are the outward normal, the direction xi in which material crosses the contact, and the direction
/// zeta perpendicular to both. See docs/theory/planes-and-pairs.md.
/// @param[in] plane layers and base, not rigid
/// @param[in] speed speed V at which material crosses the contact [m/s], > 0; a wave has the frequency V k_xi
/// @param[in] k_xi,k_zeta wave numbers [1/m], any sign, arrays of equal length; not both 0
/// @return one matrix for each pair [m/Pa]
/// @throws InvalidInput for invalid input
[[nodiscard]] std::vector<ComplexMatrix3> surface_compliance(const CoatedPlane& plane, double speed,
                                                             std::span<const double> k_xi,
                                                             std::span<const double> k_zeta);

/// @brief Surface compliance of the unbounded tread of a wheel, with inertia: displacement [m] per surface stress [Pa].
///
/// The directions are the outward normal, the circumference (phi) and the axis (z). The compliance contains the
/// curvature of the crown to first order. See docs/theory/wheels.md.
/// @param[in] wheel hub and at least one layer
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] m orders around the circumference, any sign
/// @param[in] k wave numbers across [1/m], any sign, as many as `m`
/// @return one matrix for each pair [m/Pa]
/// @throws InvalidInput for invalid input
[[nodiscard]] std::vector<ComplexMatrix3> surface_compliance(const CoatedWheel& wheel, double angular_speed,
                                                             std::span<const int> m, std::span<const double> k);

/// @brief Critical speed of a plane: the lowest speed at which a wave of its undamped layers keeps up with the rolling
/// body. The wave may be the Rayleigh wave of the outer layer or of the base, or a guided wave of the layers.
/// @param[in] plane layers and base
/// @param[in] highest_frequency same as for a sphere [rad/s]
/// @return critical speed V [m/s]; infinite without inertia, or if no short-time modulus is finite
/// @throws InvalidInput for invalid input
[[nodiscard]] double critical_speed(const CoatedPlane& plane, double highest_frequency = 1e9);

}  // namespace viscoroll
