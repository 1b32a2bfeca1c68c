#include "transient/creep_function.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

/// Spectrum with an instantaneous compliance. In a fit without one, the shortest time, far below all relevant times,
/// takes its place.
CreepSpectrum with_instantaneous_part(CreepSpectrum creep) {
  if (creep.instantaneous > 0.0) return creep;
  creep.instantaneous = creep.weights.front();
  creep.weights.erase(creep.weights.begin());
  creep.retardation_times.erase(creep.retardation_times.begin());
  return creep;
}

}  // namespace

std::complex<double> CreepFunction::at_frequency(double omega) const {
  std::complex<double> yielded = creep.instantaneous;
  for (std::size_t j = 0; j < creep.size(); ++j) {
    yielded += creep.weights[j] / std::complex<double>(1.0, omega * creep.retardation_times[j]);
  }
  return relaxed / yielded;
}

std::vector<CreepFunction> creep_functions(const std::vector<Layer>& layers, const TimeRange& range) {
  std::vector<CreepFunction> moduli;
  moduli.reserve(layers.size());
  for (const Layer& layer : layers) {
    const ShearModulus& modulus = layer.shear_modulus;
    moduli.push_back({.relaxed = complex_modulus(modulus, std::array{0.0}).front().real(),
                      .creep = with_instantaneous_part(creep_spectrum(modulus, range))});
  }
  return moduli;
}

std::vector<double> relaxation_times(const CreepSpectrum& creep) {
  // Between its poles, the compliance falls from infinity above one retardation time to minus infinity below the next.
  const CreepFunction modulus{.relaxed = 1.0, .creep = creep};
  std::vector<double> times;
  times.reserve(creep.size());
  for (std::size_t j = 0; j < creep.size(); ++j) {
    const double retardation = creep.retardation_times[j];
    // Below the shortest time the compliance is positive where time / (retardation - time) < J_0.
    double below =
        j > 0 ? creep.retardation_times[j - 1] : retardation * creep.instantaneous / (1.0 + creep.instantaneous);
    double above = retardation;
    for (;;) {
      const double middle = std::sqrt(below * above);
      if (middle <= below || middle >= above) break;
      (modulus.at(middle) > 0.0 ? below : above) = middle;
    }
    times.push_back(above);
  }
  return times;
}

}  // namespace viscoroll::detail
