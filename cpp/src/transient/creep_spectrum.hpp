/// @file
/// @brief A modulus as a creep function of discrete retardation times, docs/theory/transient.md.
///
/// mu*(0) / mu*(s) = J_0 + sum_j J_j / (1 + s lambda_j), with weights that add up to 1: what yields at once and what
/// yields in time, in units of what has yielded after an infinite time.
#pragma once

#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll::detail {

/// @brief Creep of a material, per its relaxed compliance.
struct CreepSpectrum {
  double instantaneous = 1.0;             ///< J_0 [-], 0 where nothing yields at once
  std::vector<double> weights;            ///< J_j [-], > 0
  std::vector<double> retardation_times;  ///< lambda_j [s], > 0
  double error = 0.0;                     ///< largest relative error of the compliance it stands for [-]

  [[nodiscard]] std::size_t size() const { return weights.size(); }
};

/// @brief Times between which a creep function is needed.
struct TimeRange {
  double shortest;  ///< [s]
  double longest;   ///< [s]
};

/// @brief Creep spectrum of a modulus: exact for Elastic, Prony and KelvinVoigt, the known spectrum of FractionalZener
/// by the trapezoidal rule, nonnegative least squares of 1/mu* for what was measured.
/// @param[in] modulus any shear modulus that is a solid's
/// @param[in] range in which the continuous ones are resolved: what is faster yields at once, what is slower at the end
/// @throws std::invalid_argument for bad parameters
[[nodiscard]] CreepSpectrum creep_spectrum(const ShearModulus& modulus, const TimeRange& range);

}  // namespace viscoroll::detail
