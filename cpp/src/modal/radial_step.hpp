/// @file
/// @brief One radial step through a layer, for several orders side by side.
///
/// Along and across the direction of k, v_k = (m v_phi + n v_theta) / k and v_x = (m v_theta - n v_phi) / k, and with
/// stresses in units of the layer's modulus, the equations of layer_system.hpp read
///
///     u_r' = a t + b s               s'     = -2 gamma t + (1 - 4b) s + k tau_k
///     v_k' = v_k - k u_r + tau_k     tau_k' = k (gamma t - a s) + c v_k - 2 tau_k
///     v_x' = v_x + tau_x             tau_x' = c v_x - 2 tau_x
///
/// with t = k v_k - 2 u_r and the membrane stiffness c: one number, b, is all of the material that is left. Inertia
/// adds q (1 + x)^2 M u at the radius r (1 + x), q = rho Omega^2 r^2 / mu, to the rates of the stresses. M, that of
/// `inertia_matrix` turned, couples the six.
#pragma once

#include <array>

#include "modal/lanes.hpp"

namespace viscoroll::detail {

/// @brief Symmetric 3 x 3 matrices in the directions r, k and across k.
template <class Scalar>
struct SymmetricLanes {
  Lanes<Scalar> rr, rk, rx, kk, kx, xx;
};

/// @brief Coefficients of the equations in a step.
template <class Scalar>
struct StepLanes {
  Lanes<double> k;
  Lanes<double> membrane;  ///< `membrane_stiffness`, k^2 - 2 on a sphere
  Lanes<Scalar> b;         ///< `shear_ratio`
  Lanes<double> growth;    ///< x: relative growth of the radius in the step; 0 where a lane does not take part
  bool has_inertia = false;
  Lanes<Scalar> q;                 ///< at the inner radius
  SymmetricLanes<double> inertia;  ///< M
};

/// @brief 3 x 3 matrices in the directions r, k and across k, row-major.
template <class Scalar>
using MatrixLanes = std::array<Lanes<Scalar>, 9>;

/// @brief One solution of the equations: u_r, v_k, v_x, s, tau_k, tau_x.
template <class Scalar>
using SolutionLanes = std::array<Lanes<Scalar>, 6>;

/// @brief Carry three solutions outwards by the Taylor series about the inner radius, and give the compliance D F^-1 of
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
