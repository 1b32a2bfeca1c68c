/// @file
/// @brief The compliance of flat layers, carried outwards: theory.md section 15.
///
/// With n the outward normal and the stresses in units of mu k, the equations along and across the direction of k are
///
///     u' = a v + b s     v' = -u + tau     s' = tau - e u     tau' = 4 (1 - b) v - a s - e v
///     w' = tau_w         tau_w' = (1 - e) w
///
/// per k n, with a = 1 - 2b and e = rho (k_phi V)^2 / (mu k^2). They are the sphere's (`radial_step.hpp`) without what
/// curvature adds; e moves along k and across it apart. The coefficients are constant, so a step through a layer is
/// exact, whatever its length.
#pragma once

#include <complex>
#include <span>

#include "modal/layer_system.hpp"

namespace viscoroll::detail {

/// @brief A flat layer at one frequency.
template <class Scalar>
struct FlatMedium {
  double thickness;  ///< [m]; infinite for a half-space, which comes first
  Scalar mu;         ///< shear modulus [Pa]
  Scalar b;          ///< mu / (lambda + 2 mu), see `shear_ratio`
  double inertia;    ///< rho V^2 [Pa], V the speed at which material crosses the contact
};

/// @brief Displacement per stress [m/Pa] along the normal (u), along k (k) and across both (p), in the real form of
/// layer_system.hpp: u = uu s + uk tau, v = uk s + kk tau, w = pp tau_w.
template <class Scalar>
struct FlatCompliance {
  Scalar uu, uk, kk, pp;
};

/// @brief Compliance of the surface of bonded layers. Material deeper than 40 decay lengths is left out.
/// @param[in] media from the base outwards, at least one; the base is rigid unless the first one is a half-space
/// @param[in] k wave number [1/m], > 0
/// @param[in] cosine share of k along the way in which material crosses the contact, in [0, 1]
template <class Scalar>
[[nodiscard]] FlatCompliance<Scalar> flat_compliance(std::span<const FlatMedium<Scalar>> media, double k,
                                                     double cosine);

/// @brief The same as a matrix in the directions r (the normal), phi and theta.
/// @param[in] compliance of a wave number
/// @param[in] cosine,sine its direction
template <class Scalar>
[[nodiscard]] Matrix3<Scalar> turned(const FlatCompliance<Scalar>& compliance, double cosine, double sine) {
  const auto& [uu, uk, kk, pp] = compliance;
  const Scalar mixed = (kk - pp) * (cosine * sine);
  return Matrix3<Scalar>{{uu, uk * cosine, uk * sine},
                         {uk * cosine, kk * (cosine * cosine) + pp * (sine * sine), mixed},
                         {uk * sine, mixed, kk * (sine * sine) + pp * (cosine * cosine)}};
}

/// @brief Whether the static stiffness stays positive through all layers: no resonance lies below this speed.
/// @param[in] media with real moduli
[[nodiscard]] bool is_subcritical(std::span<const FlatMedium<double>> media, double k);

extern template FlatCompliance<double> flat_compliance(std::span<const FlatMedium<double>>, double, double);
extern template FlatCompliance<std::complex<double>> flat_compliance(std::span<const FlatMedium<std::complex<double>>>,
                                                                     double, double);

}  // namespace viscoroll::detail
