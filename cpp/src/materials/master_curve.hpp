/// @file
/// @brief Check and interpolation of a tabulated modulus.
#pragma once

#include <complex>
#include <string_view>

#include "viscoroll/materials.hpp"

namespace viscoroll::detail {

/// @brief Check a tabulated modulus.
/// @param[in] curve table
/// @param[in] prefix text before the parameter's name in messages
/// @throws InvalidInput if the table is short or unsorted, has columns of unequal length, or a value is out of
/// range
void validate_table(const MasterCurve& curve, std::string_view prefix);

/// @brief Modulus at one frequency, linear in log(frequency) between entries.
/// @param[in] curve a valid table
/// @param[in] omega angular frequency [rad/s], >= 0
/// @return complex shear modulus [Pa]
/// @throws InvalidInput outside the table, unless the curve holds its end values
[[nodiscard]] std::complex<double> interpolate(const MasterCurve& curve, double omega);

}  // namespace viscoroll::detail
