/// @file
/// @brief Checks of values. A message names parameter, requirement with unit, and the given value.
#pragma once

#include <string>
#include <string_view>

namespace viscoroll::detail {

/// @return shortest decimal text from which `value` can be read back exactly
[[nodiscard]] std::string text(double value);

/// @return decimal text with three significant digits
[[nodiscard]] std::string rounded(double value);

/// @brief Reject a value with the message "<name> must be <requirement>, got <value>".
/// @throws InvalidInput always
[[noreturn]] void reject(std::string_view name, std::string_view requirement, std::string_view value);
[[noreturn]] void reject(std::string_view name, std::string_view requirement, double value);

/// Range of positive numbers in SI units. The seventh power of such a number is finite, and so are the products of
/// several numbers. Lengths, times, moduli and loads in practice are far within this range.
inline constexpr double kSmallestNumber = 1e-40;
inline constexpr double kLargestNumber = 1e40;

/// @brief Check a positive number.
/// @param[in] name name of the parameter
/// @param[in] value value to check
/// @param[in] unit unit for the message; empty for a pure number
/// @throws InvalidInput unless `value` is in [kSmallestNumber, kLargestNumber]
void require_positive(std::string_view name, double value, std::string_view unit);

/// @brief Check a nonnegative number.
/// @throws InvalidInput unless `value` is in [0, kLargestNumber]
void require_nonnegative(std::string_view name, double value, std::string_view unit);

/// Largest ratio of two lengths of a body. Positions of boundaries are stored as distances from the center, to 1e-16 of
/// the radius, which leaves seven digits of the thickness of the thinnest layer.
inline constexpr double kLargestLengthRatio = 1e9;

/// @brief Check a length of a body.
/// @param[in] name name of the parameter
/// @param[in] value length [m]
/// @param[in] radius radius of the body [m]
/// @param[in] body noun of the body for the message
/// @throws InvalidInput unless `value` is at least radius / kLargestLengthRatio
void require_length(std::string_view name, double value, double radius, std::string_view body);

/// Largest coefficient of friction [-]. No pair of materials exceeds it.
inline constexpr double kLargestFriction = 4.0;

/// @brief Check a coefficient of friction.
/// @throws InvalidInput unless `value` is in [0, kLargestFriction], or infinite for full stick
void require_friction(double value);

/// @brief Check that a number is finite.
/// @throws InvalidInput unless `value` is finite
void require_finite(std::string_view name, double value);

}  // namespace viscoroll::detail
