// Persson's estimate of contact area and friction.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/validate.hpp"
#include "sliding/map_spectrum.hpp"
#include "sliding/sliding_input.hpp"
#include "sliding/sliding_symbol.hpp"

namespace viscoroll {

PerssonEstimate persson_estimate(const HeightMap& map, const CoatedPlane& on, double pressure, double speed,
                                 double gamma, const SlidingOptions& options) {
  detail::validate_sliding(map, on, pressure, speed, options);
  detail::require_in({.minimum = 0.0, .maximum = 1.0}, "gamma", gamma);
  if (!map.periodic) detail::reject("heights", "a periodic surface", "one that is not periodic");
  detail::Watch watch(options.observer);
  const detail::SlidingPeriod period = detail::period_of(map);
  const detail::SlidingSymbol symbol(on, period, speed, 0.0, options.threads, watch);

  /// Contribution of a wave to the pressure of full contact and to the loss.
  struct Wave {
    double square;    // k^2 [1/m^2]
    double variance;  // of the pressure [Pa^2]
    double loss;      // per area and distance [Pa]
  };
  std::vector<Wave> waves;
  detail::MapSpectrum(detail::heights_against_path(map), period.nodes)
      .for_waves([&](int i, int j, std::complex<double> height, double weight) {
        const double k_x = period.k_x(i);
        const double k_z = period.is_line() ? 0.0 : period.k_z(j);
        const std::complex<double> stiffness = 1.0 / symbol(i, j);
        waves.push_back({.square = k_x * k_x + k_z * k_z,
                         .variance = weight * std::norm(height * stiffness),
                         .loss = weight * std::norm(height) * std::abs(k_x * stiffness.imag())});
      });
  std::ranges::sort(waves, {}, &Wave::square);

  PerssonEstimate estimate{.friction_coefficient = 0.0, .contact_share = 1.0};
  double variance = 0.0;
  for (auto wave = waves.begin(); wave != waves.end();) {
    // Waves of the same length belong to the same share of contact.
    constexpr double kRoundOff = 1e-12;
    double loss = 0.0;
    for (const double longest = wave->square * (1.0 + kRoundOff); wave != waves.end() && wave->square <= longest;
         ++wave) {
      variance += wave->variance;
      loss += wave->loss;
    }
    const double share = variance > 0.0 ? std::erf(pressure / std::sqrt(2.0 * variance)) : 1.0;
    estimate.friction_coefficient += loss * share * (gamma + (1.0 - gamma) * share * share) / pressure;
    estimate.contact_share = share;
  }
  return estimate;
}

}  // namespace viscoroll
