/// @file
/// @brief Creep spectra in saved states, which go on with the retardation times that they were made with.
#pragma once

#include "transient/creep_spectrum.hpp"
#include "transient/numbers.hpp"

namespace viscoroll::detail {

/// @return largest difference of two creep functions, per what has yielded after an infinite time [-]
[[nodiscard]] double difference(const CreepSpectrum& a, const CreepSpectrum& b);

void write(const CreepSpectrum& spectrum, NumberWriter& numbers);

/// @throws std::invalid_argument where the numbers are no spectrum
[[nodiscard]] CreepSpectrum read_spectrum(NumberReader& numbers);

}  // namespace viscoroll::detail
