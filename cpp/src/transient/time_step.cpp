#include "transient/time_step.hpp"

#include <cmath>

namespace viscoroll::detail {
namespace {

/// Coefficients of a step z = duration / lambda; for small z, differences are computed by series.
TimeStep::Term term_of(double weight, double z) {
  constexpr double kSmall = 1e-3;
  const double decay = std::exp(-z);
  const double passed = -std::expm1(-z);
  const double mean = z > 0.0 ? passed / z : 1.0;  // mean of the decay over the step
  const double on_new = z < kSmall ? z / 2.0 - z * z / 6.0 + z * z * z / 24.0 : 1.0 - mean;
  const double on_old = passed - on_new;
  const double twice = -0.5 * std::expm1(-2.0 * z);
  // Integral of (1 - e^-t)^2 over t < z, divided by z^2.
  const double ramp =
      z < kSmall ? z / 3.0 - z * z / 4.0 + 7.0 * z * z * z / 60.0 : (z - 2.0 * passed + twice) / (z * z);
  return {.weight = weight,
          .decay = decay,
          .on_old = on_old,
          .on_new = on_new,
          .lost_change = weight * ramp,
          .lost_mixed = weight * passed * mean,
          .lost_state = weight * twice};
}

}  // namespace

TimeStep::TimeStep(const CreepSpectrum& spectrum, double duration) : compliance(spectrum.instantaneous) {
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    terms.push_back(term_of(spectrum.weights[j], duration / spectrum.retardation_times[j]));
    compliance += terms.back().weight * terms.back().on_new;
  }
}

}  // namespace viscoroll::detail
