/// @file
/// @brief Checking and interpolating a tabulated modulus.
#pragma once

#include <complex>
#include <string_view>

#include "viscoroll/materials.hpp"

namespace viscoroll::detail {

/// @throws std::invalid_argument where the table is short, unsorted, of unequal columns or out of range
void validate_table(const MasterCurve& curve, std::string_view prefix);

/// @brief Modulus at one frequency, linear in log(frequency) between entries.
/// @param[in] curve a valid table
/// @param[in] omega [rad/s], >= 0
/// @throws std::invalid_argument outside the table, unless the curve holds its end values
[[nodiscard]] std::complex<double> interpolate(const MasterCurve& curve, double omega);

}  // namespace viscoroll::detail
