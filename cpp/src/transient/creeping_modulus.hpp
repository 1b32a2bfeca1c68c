/// @file
/// @brief Moduli off the axis of real frequencies, where a body's retardation times are looked for:
/// docs/theory/transient.md, "Layers with different relaxation functions".
///
/// In place of s stands the time -1/s, which is positive where a body of discrete times may have one of its own.
#pragma once

#include <complex>
#include <vector>

#include "transient/creep_spectrum.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief A shear modulus by its creep.
struct CreepingModulus {
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

/// @brief The moduli of layers that creep, each by itself.
/// @param[in] layers whose moduli yield in part at once: KelvinVoigt does not
/// @param[in] range in which continuous spectra are resolved
/// @throws std::invalid_argument for bad parameters
[[nodiscard]] std::vector<CreepingModulus> creeping_moduli(const std::vector<Layer>& layers, const TimeRange& range);

/// @return times at which a modulus has its poles, ascending: one below each of its retardation times [s]
[[nodiscard]] std::vector<double> relaxation_times(const CreepSpectrum& creep);

}  // namespace viscoroll::detail
