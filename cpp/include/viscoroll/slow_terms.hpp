/// @file
/// @brief Moduli in steady rolling, where terms of a Prony series may be too slow to relax.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll {

/// @brief Smallest product of angular speed and relaxation time of a term that does not relax at rest.
inline constexpr double kSlowTerm = 1e6;

/// @brief Terms of a Prony series that are too slow to relax while a body rolls steadily.
///
/// Rolling loads a material at the frequencies m Omega with m >= 1, and at rest, m = 0. A term with Omega tau >> 1 is
/// elastic at all of the former. At rest it relaxes completely, but only after a time of several tau. Terms with
/// Omega tau >= `kSlowTerm`, which is 160 000 revolutions, are kept at rest: their moduli are part of the modulus at
/// m = 0. At m >= 1 they remain terms. There they add at most sum g / (m Omega tau) / sum g <= 1 / `kSlowTerm` to the
/// loss tangent, whatever their weights, because the storage modulus includes the moduli of the same terms. If the loss
/// tangent at the contact frequency is at least 0.01, a series without these terms and with the same modulus at rest
/// thus has the same rolling resistance coefficient within 1e-4.
struct SlowTerms {
  std::size_t count;       ///< number of the terms
  double shortest_time;    ///< shortest relaxation time among them [s]
  double modulus;          ///< sum of their moduli [Pa]
  double modulus_at_rest;  ///< modulus at m = 0: the relaxed modulus and the moduli of the terms [Pa]
};

/// @param[in] modulus any shear modulus
/// @param[in] angular_speed Omega [rad/s], > 0
/// @return the terms, none if the modulus has none
[[nodiscard]] std::optional<SlowTerms> slow_terms(const ShearModulus& modulus, double angular_speed);

/// @brief Complex shear modulus in steady rolling.
/// @param[in] modulus any shear modulus
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] omega angular frequencies [rad/s], >= 0
/// @return one value for each frequency [Pa]; at frequency 0 slow terms are not relaxed
/// @throws InvalidInput same as `complex_modulus`, and for a Prony series without modulus at rest, with the speed from
/// which on its slowest term does not relax
[[nodiscard]] std::vector<std::complex<double>> modulus_in_rolling(const ShearModulus& modulus, double angular_speed,
                                                                   std::span<const double> omega);

}  // namespace viscoroll
