/// @file
/// @brief Creep of a modulus with discrete retardation times, docs/theory/transient.md.
///
/// mu*(0) / mu*(s) = J_0 + sum_j J_j / (1 + s lambda_j) with weights that add up to 1: J_0 is the instantaneous and J_j
/// the delayed compliance, relative to the relaxed compliance.
#pragma once

#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll::detail {

/// @brief Creep of a material, relative to its relaxed compliance.
struct CreepSpectrum {
  double instantaneous = 1.0;             ///< J_0 [-]; 0 without an instantaneous compliance
  std::vector<double> weights;            ///< J_j [-], > 0
  std::vector<double> retardation_times;  ///< lambda_j [s], > 0
  double error = 0.0;                     ///< largest relative error of the compliance due to the spectrum [-]

  [[nodiscard]] std::size_t size() const { return weights.size(); }
};

/// @brief Times between which a creep function is needed.
struct TimeRange {
  double shortest;  ///< [s]
  double longest;   ///< [s]
};

/// @brief Creep spectrum of a modulus: exact for Elastic, Prony and KelvinVoigt, by the trapezoidal rule over the known
/// spectrum of FractionalZener, and by nonnegative least squares of 1/mu* for measured moduli.
/// @param[in] modulus shear modulus of a solid
/// @param[in] range in which continuous spectra are resolved; faster terms join the instantaneous compliance, and
/// slower terms form the slowest term
/// @throws InvalidInput for bad parameters
[[nodiscard]] CreepSpectrum creep_spectrum(const ShearModulus& modulus, const TimeRange& range);

/// @return largest difference of two creep functions, relative to their relaxed values [-]
[[nodiscard]] double difference(const CreepSpectrum& a, const CreepSpectrum& b);

}  // namespace viscoroll::detail
