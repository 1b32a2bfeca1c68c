/// @file
/// @brief Response of the exact sphere to vector spherical harmonics, docs/theory/layers.md.
///
/// With Y_lm the scalar harmonics, Psi = r grad Y / sqrt(L) and Phi = e_r x Psi, L = l (l + 1), displacement
/// u Y + v Psi + w Phi and stress s Y + tau Psi + chi Phi obey the equations of layer_system.hpp with k^2 = L and the
/// membrane stiffness L - 2: (u, v, s, tau) those of the direction of k, (w, chi) those across it. The order m enters
/// by the modulus mu*(m Omega) alone.
#pragma once

#include <complex>
#include <vector>

#include "modal/harmonic_body.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Compliance of one degree l at one order m [m/Pa].
struct DegreeCompliance {
  std::complex<double> radial;  ///< u by s
  std::complex<double> mixed;   ///< u by tau, and v by s
  std::complex<double> along;   ///< v by tau
  std::complex<double> across;  ///< w by chi
};

/// @brief Compliance of degree l, by solving the layers.
///
/// Without a core degree 1 holds the rigid motions. Its displacement is then that which the ball has beyond its mean
/// over the volume, with the resultant of the stress balanced by a force that is uniform over the volume, as weight is;
/// and the surface does not turn as a whole.
/// @param[in] layers of a sphere as the order m sees them, with `Curvature::exact`
/// @param[in] degree l >= 0
[[nodiscard]] DegreeCompliance degree_compliance(const LayerStack<std::complex<double>>& layers, int degree);

/// @brief Compliances of many degrees at the i-th order m of a coating, cheaply.
/// @param[in] body a sphere with `Curvature::sphere`, which differs from the exact sphere below degree 2 alone
/// @param[in] spectrum of it, up to the order n = highest + 1
/// @param[in] i number of the order m, a whole one
/// @param[in] highest degree
/// @return of the degrees m, m + 1, ..., highest
[[nodiscard]] std::vector<DegreeCompliance> degree_compliances(const HarmonicBody& body, const Spectrum& spectrum,
                                                               std::size_t i, int highest);

}  // namespace viscoroll::detail
