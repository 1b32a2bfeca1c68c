/// @file
/// @brief One step outwards through a layer, for several orders side by side.
///
/// Let v_k = (m v_phi + n v_theta) / k and v_x = (m v_theta - n v_phi) / k be the displacements along and across the
/// direction of k. With stresses in units of the layer's modulus, every body satisfies
///
///     u_r' = a t + b s               s'     = -p gamma t + (c - 2 p b) s + k tau_k
///     v_k' = c v_k - k u_r + tau_k   tau_k' = k (gamma t - a s) + f v_k - p tau_k
///     v_x' = d v_x + tau_x           tau_x' = g v_x - 2 d tau_x
///
/// with t = k v_k - p u_r. The number b is the only parameter of the material. c is 1 if the surface is curved along k,
/// d is 1 if it is curved across k; otherwise they are 0. p = c + d.
///
/// - Sphere: ' = d/d ln r, stresses multiplied by r, c = d = 1 and gamma = 3 - 4b; f = g is the membrane stiffness, as
///   in layer_system.hpp.
/// - Cylinder in plane strain, with k along its circumference: c = 1, d = 0, gamma = 4 (1 - b) and f = 0; g = k^2
///   belongs to the axial displacement. See docs/theory/rollers.md.
/// - Plane: ' = d/dy, lengths in units of the metric's radius; the coefficients are those of the cylinder with c = 0.
///   See docs/theory/planes-and-pairs.md.
///
/// Inertia adds q M u to the derivatives of the stresses, where q = rho Omega^2 r^2 / mu. On a plane M is the unit
/// matrix times -m^2. Around a center M is the rotated `inertia_matrix`, which couples all six equations; q grows by
/// (1 + x)^2 up to the radius r (1 + x).
///
/// A wheel is curved along the path and straight across. Its order across, kappa, increases with the radius, so that
/// the direction of k changes with the radius and the equations along and across k do not decouple. The equations are
/// those in the directions r, phi and z, with e = m v_phi - u_r, t = e + kappa v_z and a = 1 - 2b
/// (docs/theory/wheels.md):
///
///     u_r'   = a t + b s              s'       = a s + m tau_phi + kappa tau_z - 2 (a t + e)
///     v_phi' = v_phi - m u_r + tau_phi   tau_phi' = -tau_phi - m a s + 2m (a t + e) + kappa (kappa v_phi + m v_z)
///     v_z'   = -kappa u_r + tau_z     tau_z'   = -kappa a s + 2 kappa (a t + kappa v_z) + m (kappa v_phi + m v_z)
#pragma once

#include <array>

#include "modal/lanes.hpp"

namespace viscoroll::detail {

/// @brief Symmetric 3 x 3 matrices in the directions r, k and across k, on a wheel r, phi and z.
template <class Scalar>
struct SymmetricLanes {
  Lanes<Scalar> rr, rk, rx, kk, kx, xx;
};

/// @brief Coefficients of the equations in one step.
template <class Scalar>
struct StepLanes {
  double along = 1.0;      ///< c
  double across = 1.0;     ///< d
  double area = 3.0;       ///< gamma + 4b
  Lanes<double> k;         ///< k; on a wheel m
  Lanes<double> kappa;     ///< order across at the inner end, on a wheel
  Lanes<double> membrane;  ///< f
  Lanes<double> shear;     ///< g
  Lanes<Scalar> b;         ///< `shear_ratio`
  Lanes<double> growth;    ///< x: relative increase of the radius, or of the height per radius; 0 for an inactive lane
  bool is_wheel = false;
  bool has_inertia = false;
  Lanes<Scalar> q;                 ///< q at the inner end
  SymmetricLanes<double> inertia;  ///< M
};

/// @brief 3 x 3 matrices in the same directions, row-major.
template <class Scalar>
using MatrixLanes = std::array<Lanes<Scalar>, 9>;

/// @brief One solution of the equations: u_r, v_k, v_x, s, tau_k, tau_x; on a wheel phi and z replace k and x.
template <class Scalar>
using SolutionLanes = std::array<Lanes<Scalar>, 6>;

/// @brief Carry three solutions outwards by the Taylor series about the inner end of the step, and compute the
/// compliance D F^-1 from their displacements D and stresses F at the outer end.
void advance(const StepLanes<double>& step, const std::array<SolutionLanes<double>, 3>& start,
             SymmetricLanes<double>& compliance);
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance);

/// @brief Carry three solutions outwards, and also return F^-1: the amplitudes of the three solutions per stress at the
/// outer end.
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance, MatrixLanes<std::complex<double>>& inverse_stress);

}  // namespace viscoroll::detail
