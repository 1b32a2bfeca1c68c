/// @file
/// @brief One step outwards through a layer, for several orders side by side.
///
/// Along and across the direction of k, v_k = (m v_phi + n v_theta) / k and v_x = (m v_theta - n v_phi) / k, and with
/// stresses in units of the layer's modulus, every body obeys
///
///     u_r' = a t + b s               s'     = -p gamma t + (c - 2 p b) s + k tau_k
///     v_k' = c v_k - k u_r + tau_k   tau_k' = k (gamma t - a s) + f v_k - p tau_k
///     v_x' = d v_x + tau_x           tau_x' = g v_x - 2 d tau_x
///
/// with t = k v_k - p u_r: one number, b, is all of the material that is left. c and d are 1 where the surface is a
/// ring along k and across it, else 0, and p = c + d.
///
/// - Sphere: ' = d/d ln r, stresses times r, c = d = 1, gamma = 3 - 4b, and f = g is the membrane stiffness, as in
///   layer_system.hpp.
/// - Cylinder in plane strain, k along its ring: c = 1 and d = 0, gamma = 4 (1 - b) and f = 0, and g = k^2 is of what
///   moves along its axis. See docs/theory/rollers.md.
/// - Plane: ' = d/dy, lengths per radius of the metric; as on the cylinder, but c = 0. See
///   docs/theory/planes-and-pairs.md.
///
/// Inertia adds q M u to the rates of the stresses, q = rho Omega^2 r^2 / mu. On a ring q grows as (1 + x)^2 up to the
/// radius r (1 + x), and M, that of `inertia_matrix` turned, couples the six; on a plane it is -m^2.
///
/// On a wheel, a ring along and straight across, kappa, the order across at a radius, grows with it, so that the
/// direction of k turns from radius to radius and no direction parts from the others. The six are those of r, phi and
/// z, with e = m v_phi - u_r, t = e + kappa v_z and a = 1 - 2b (docs/theory/wheels.md):
///
///     u_r'   = a t + b s              s'       = a s + m tau_phi + kappa tau_z - 2 (a t + e)
///     v_phi' = v_phi - m u_r + tau_phi   tau_phi' = -tau_phi - m a s + 2m (a t + e) + kappa (kappa v_phi + m v_z)
///     v_z'   = -kappa u_r + tau_z     tau_z'   = -kappa a s + 2 kappa (a t + kappa v_z) + m (kappa v_phi + m v_z)
#pragma once

#include <array>

#include "modal/lanes.hpp"

namespace viscoroll::detail {

/// @brief Symmetric 3 x 3 matrices in the directions r, k and across k, or r, phi and z of a wheel.
template <class Scalar>
struct SymmetricLanes {
  Lanes<Scalar> rr, rk, rx, kk, kx, xx;
};

/// @brief Coefficients of the equations in a step.
template <class Scalar>
struct StepLanes {
  double along = 1.0;      ///< c
  double across = 1.0;     ///< d
  double area = 3.0;       ///< gamma + 4b
  Lanes<double> k;         ///< m on a wheel
  Lanes<double> kappa;     ///< at the inner end, of a wheel
  Lanes<double> membrane;  ///< f
  Lanes<double> shear;     ///< g
  Lanes<Scalar> b;         ///< `shear_ratio`
  Lanes<double> growth;    ///< x: growth of the radius, or height, per radius; 0 where a lane does not take part
  bool is_wheel = false;
  bool has_inertia = false;
  Lanes<Scalar> q;                 ///< at the inner end
  SymmetricLanes<double> inertia;  ///< M
};

/// @brief 3 x 3 matrices in the same directions, row-major.
template <class Scalar>
using MatrixLanes = std::array<Lanes<Scalar>, 9>;

/// @brief One solution of the equations: u_r, v_k, v_x, s, tau_k, tau_x, or with phi and z for k and x.
template <class Scalar>
using SolutionLanes = std::array<Lanes<Scalar>, 6>;

/// @brief Carry three solutions outwards by the Taylor series about the inner end, and give the compliance D F^-1 of
/// their displacements D and stresses F there.
void advance(const StepLanes<double>& step, const std::array<SolutionLanes<double>, 3>& start,
             SymmetricLanes<double>& compliance);
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance);

/// @brief The same, and F^-1 itself: what the stresses at the outer end make of the three starts.
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance, MatrixLanes<std::complex<double>>& inverse_stress);

}  // namespace viscoroll::detail
