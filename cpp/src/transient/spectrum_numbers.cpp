#include "transient/spectrum_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace viscoroll::detail {

double difference(const CreepSpectrum& a, const CreepSpectrum& b) {
  const auto creep = [](const CreepSpectrum& spectrum, double time) {
    double yielded = spectrum.instantaneous;
    for (std::size_t j = 0; j < spectrum.size(); ++j) {
      yielded -= spectrum.weights[j] * std::expm1(-time / spectrum.retardation_times[j]);
    }
    return yielded;
  };
  double largest = 0.0;
  for (const auto* spectrum : {&a, &b}) {
    for (const double time : spectrum->retardation_times) {
      largest = std::max(largest, std::abs(creep(a, time) - creep(b, time)));
    }
  }
  return largest;
}

void write(const CreepSpectrum& spectrum, NumberWriter& numbers) {
  const auto vector = [&](const std::vector<double>& values) {
    numbers.put(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  numbers.put(spectrum.instantaneous);
  vector(spectrum.weights);
  vector(spectrum.retardation_times);
  numbers.put(spectrum.error);
}

CreepSpectrum read_spectrum(NumberReader& numbers) {
  const auto vector = [&] {
    const Eigen::MatrixXd values = numbers.matrix();
    return std::vector<double>(values.data(), values.data() + values.size());
  };
  CreepSpectrum spectrum;
  spectrum.instantaneous = numbers.get();
  spectrum.weights = vector();
  spectrum.retardation_times = vector();
  spectrum.error = numbers.get();
  NumberReader::require(spectrum.weights.size() == spectrum.retardation_times.size());
  NumberReader::require(std::ranges::all_of(spectrum.retardation_times, [](double time) { return time > 0.0; }));
  return spectrum;
}

}  // namespace viscoroll::detail
