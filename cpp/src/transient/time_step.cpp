#include "transient/time_step.hpp"

#include <cmath>

namespace viscoroll::detail {
namespace {

/// Coefficients of a term for a step of z = duration / retardation time. For small z, power series replace the
/// differences of nearly equal numbers.
TimeStep::Term term_of(double weight, double z) {
  constexpr double kSmall = 1e-3;
  const double decay = std::exp(-z);
  const double creep = -std::expm1(-z);                 // 1 - decay
  const double mean_decay = z > 0.0 ? creep / z : 1.0;  // mean of e^-t over t < z
  const double on_new = z < kSmall ? z / 2.0 - z * z / 6.0 + z * z * z / 24.0 : 1.0 - mean_decay;
  const double on_old = creep - on_new;
  const double squared_decay = -0.5 * std::expm1(-2.0 * z);  // integral of e^-2t over t < z
  // Integral of (1 - e^-t)^2 over t < z, divided by z^2.
  const double ramp =
      z < kSmall ? z / 3.0 - z * z / 4.0 + 7.0 * z * z * z / 60.0 : (z - 2.0 * creep + squared_decay) / (z * z);
  return {.weight = weight,
          .decay = decay,
          .on_old = on_old,
          .on_new = on_new,
          .lost_change = weight * ramp,
          .lost_mixed = weight * creep * mean_decay,
          .lost_state = weight * squared_decay};
}

}  // namespace

TimeStep::TimeStep(const CreepSpectrum& spectrum, double duration) : compliance(spectrum.instantaneous) {
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    terms.push_back(term_of(spectrum.weights[j], duration / spectrum.retardation_times[j]));
    compliance += terms.back().weight * terms.back().on_new;
  }
}

}  // namespace viscoroll::detail
