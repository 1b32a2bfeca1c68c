/// @file
/// @brief Creep spectra in saved states, so that a history continues with the retardation times with which it began.
#pragma once

#include "transient/creep_spectrum.hpp"
#include "transient/numbers.hpp"

namespace viscoroll::detail {

/// @return largest difference of two creep functions, relative to their relaxed values [-]
[[nodiscard]] double difference(const CreepSpectrum& a, const CreepSpectrum& b);

void write(const CreepSpectrum& spectrum, NumberWriter& numbers);

/// @throws InvalidInput if the numbers do not form a spectrum
[[nodiscard]] CreepSpectrum read_spectrum(NumberReader& numbers);

}  // namespace viscoroll::detail
