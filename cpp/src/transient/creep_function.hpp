/// @file
/// @brief Moduli off the axis of real frequencies, where the retardation times of a body lie.
///
/// See docs/theory/transient.md, "Layers with different relaxation functions".
///
/// The time -1/s takes the place of s. It is positive where a body with discrete times may have a retardation time.
#pragma once

#include <complex>
#include <vector>

#include "transient/creep_spectrum.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Shear modulus, given by its creep function.
struct CreepFunction {
  double relaxed;       ///< mu*(0) [Pa]
  CreepSpectrum creep;  ///< times ascending, J_0 > 0

  /// @return mu*(s) at s = -1/time [Pa]
  template <class Scalar>
  [[nodiscard]] Scalar at(const Scalar& time) const {
    Scalar yielded = creep.instantaneous;
    for (std::size_t j = 0; j < creep.size(); ++j) {
      yielded += creep.weights[j] * time / (time - creep.retardation_times[j]);
    }
    return relaxed / yielded;
  }

  /// @return mu*(infinity) [Pa]
  [[nodiscard]] double instantaneous() const { return relaxed / creep.instantaneous; }
  /// @return mu*(i w) at a frequency [rad/s], [Pa]
  [[nodiscard]] std::complex<double> at_frequency(double omega) const;
};

/// @brief Moduli of layers with their own creep functions.
/// @param[in] layers layers with an instantaneous compliance, which excludes KelvinVoigt
/// @param[in] range in which continuous spectra are resolved
/// @throws InvalidInput for bad parameters
[[nodiscard]] std::vector<CreepFunction> creep_functions(const std::vector<Layer>& layers, const TimeRange& range);

/// @return relaxation times, which are the poles of the modulus, ascending: one below each retardation time [s]
[[nodiscard]] std::vector<double> relaxation_times(const CreepSpectrum& creep);

}  // namespace viscoroll::detail
