/// @file
/// @brief Response of the exact sphere to vector spherical harmonics (docs/theory/layers.md).
///
/// Let Y_lm be the scalar harmonics, Psi = r grad Y / sqrt(L) and Phi = e_r x Psi with L = l (l + 1). The displacement
/// u Y + v Psi + w Phi and the stress s Y + tau Psi + chi Phi satisfy the equations of layer_system.hpp with k^2 = L
/// and the membrane stiffness L - 2. (u, v, s, tau) satisfy those along k, and (w, chi) those across it. The order m
/// enters through the modulus mu*(m Omega) only.
#pragma once

#include <complex>
#include <vector>

#include "modal/harmonic_body.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Compliance of one degree l at one order m [m/Pa].
struct DegreeCompliance {
  std::complex<double> radial;  ///< u per s
  std::complex<double> mixed;   ///< u per tau, and v per s
  std::complex<double> along;   ///< v per tau
  std::complex<double> across;  ///< w per chi
};

/// @brief Compliance of degree l, computed from the layers.
///
/// Without a core, degree 1 contains the rigid motions. A body force that is uniform over the volume, like weight, then
/// balances the resultant of the stress. Displacements are relative to their mean over the volume, and the rotation of
/// the surface as a whole is 0.
/// @param[in] layers layers of a sphere with their moduli at the order m, with `Curvature::exact`
/// @param[in] degree degree l >= 0
[[nodiscard]] DegreeCompliance degree_compliance(const LayerStack<std::complex<double>>& layers, int degree);

/// @brief Compliances of many degrees at the i-th order m of a sphere, from its spectrum.
/// @param[in] body sphere with `Curvature::sphere`, which differs from the exact sphere only below degree 2
/// @param[in] spectrum spectrum of the body, up to the order n = highest + 1
/// @param[in] i index of the order m, a whole number
/// @param[in] highest highest degree
/// @return compliances of the degrees m, m + 1, ..., highest
[[nodiscard]] std::vector<DegreeCompliance> degree_compliances(const HarmonicBody& body, const Spectrum& spectrum,
                                                               std::size_t i, int highest);

}  // namespace viscoroll::detail
