/// @file
/// @brief Moduli of layers at the frequencies m Omega.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Complex shear moduli of layers at the frequencies m Omega.
/// @param[in] layers of a coating
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] orders m >= 0, not necessarily whole
/// @param[in] measured_order materials that were measured, `MasterCurve` and `CustomModulus`, are not asked for
/// frequencies beyond this order's: from about half of it on they are taken at lower ones
/// @return [layer][order] [Pa]
[[nodiscard]] std::vector<std::vector<std::complex<double>>> harmonic_moduli(const std::vector<Layer>& layers,
                                                                             double angular_speed,
                                                                             const std::vector<double>& orders,
                                                                             double measured_order);

/// @brief The same at other orders.
/// @param[in] layers of a body
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] orders m
/// @param[in] measured moduli that were measured, a row for each order and a column for each of `measured_layers`
/// @return [layer][order] [Pa]
[[nodiscard]] std::vector<std::vector<std::complex<double>>> resampled_moduli(const std::vector<Layer>& layers,
                                                                              double angular_speed,
                                                                              const std::vector<double>& orders,
                                                                              const Eigen::ArrayXXcd& measured);

/// @return the highest frequency at which measured materials are asked for theirs [rad/s]
[[nodiscard]] double highest_frequency(double angular_speed, const std::vector<double>& orders, double measured_order);

/// @return whether a modulus was measured, and so may have kinks
[[nodiscard]] bool is_measured(const ShearModulus& modulus);

/// @return those of some layers
[[nodiscard]] std::vector<std::size_t> measured_layers(const std::vector<Layer>& layers);

}  // namespace viscoroll::detail
