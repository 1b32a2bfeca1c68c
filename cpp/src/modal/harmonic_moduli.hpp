/// @file
/// @brief Moduli of layers at the frequencies m Omega, and the kinks of moduli that are measured.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

#include "viscoroll/materials.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Complex shear moduli of layers at the frequencies m Omega, with slow terms at rest as in `slow_terms.hpp`.
/// @param[in] layers layers of a body
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] orders orders m >= 0, not necessarily whole numbers
/// @param[in] measured_order highest order at which measured moduli, `MasterCurve` and `CustomModulus`, are evaluated;
/// orders above about half of it are replaced by lower ones that approach it smoothly
/// @return moduli [Pa], [layer][order]
[[nodiscard]] std::vector<std::vector<std::complex<double>>> harmonic_moduli(const std::vector<Layer>& layers,
                                                                             double angular_speed,
                                                                             const std::vector<double>& orders,
                                                                             double measured_order);

/// @brief Complex shear moduli of layers at other orders, with given values of the measured moduli.
/// @param[in] layers layers of a body
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] orders orders m
/// @param[in] measured measured moduli [Pa], a row for each order and a column for each of `measured_layers`
/// @return moduli [Pa], [layer][order]
[[nodiscard]] std::vector<std::vector<std::complex<double>>> resampled_moduli(const std::vector<Layer>& layers,
                                                                              double angular_speed,
                                                                              const std::vector<double>& orders,
                                                                              const Eigen::ArrayXXcd& measured);

/// @return highest frequency at which measured moduli are evaluated [rad/s]
[[nodiscard]] double highest_frequency(double angular_speed, const std::vector<double>& orders, double measured_order);

/// @return whether a modulus is measured (a table or a user's function), so that it may have kinks
[[nodiscard]] bool is_measured(const ShearModulus& modulus);

/// @return whether a modulus has no loss at any frequency, by its parameters. The values of a user's function are not
/// known, so that it counts as lossy.
[[nodiscard]] bool is_lossless(const ShearModulus& modulus);

/// @return indices of the layers with measured moduli
[[nodiscard]] std::vector<std::size_t> measured_layers(const std::vector<Layer>& layers);

/// @brief Find the highest frequency up to which a modulus has kinks, from samples in [low, high].
///
/// Polynomials in the logarithm of the frequency resolve every sum of relaxations in an octave. An octave in which they
/// do not resolve the modulus has a kink.
/// @param[in] modulus any shear modulus
/// @param[in] low,high angular frequencies [rad/s], > 0
/// @return end of the highest octave with a kink [rad/s]; 0 without kinks; `high` if the modulus has no value at a
/// sample
[[nodiscard]] double highest_kink(const ShearModulus& modulus, double low, double high);

}  // namespace viscoroll::detail
