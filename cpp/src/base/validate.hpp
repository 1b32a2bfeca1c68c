/// @file
/// @brief Checks of values. A message names parameter, requirement with unit, and the given value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {

/// @return shortest decimal text from which `value` can be read back exactly
[[nodiscard]] std::string text(double value);

/// @return decimal text with three significant digits
[[nodiscard]] std::string rounded(double value);

/// @brief Reject a value with the message "<name> must be <requirement>, got <value>".
/// @param[in] name name of the parameter
/// @param[in] requirement end of the rule
/// @param[in] value value, or its text
/// @param[in] range range of which the requirement is the text, if it is one
/// @throws InvalidInput always
[[noreturn]] void reject(std::string_view name, std::string_view requirement, std::string_view value,
                         std::optional<Range> range = {});
[[noreturn]] void reject(std::string_view name, std::string_view requirement, double value,
                         std::optional<Range> range = {});

/// @brief Reject a value outside of a range with the message "<name> must be <range><reason>, got <value>".
/// @param[in] name name of the parameter
/// @param[in] range allowed values
/// @param[in] value value, or its text
/// @param[in] reason continues the text of the range; may be empty
/// @throws InvalidInput always
[[noreturn]] void reject(std::string_view name, const Range& range, std::string_view value,
                         std::string_view reason = "");
[[noreturn]] void reject(std::string_view name, const Range& range, double value, std::string_view reason = "");

/// @brief Check a number.
/// @throws InvalidInput unless `range` contains `value`
void require_in(const Range& range, std::string_view name, double value, std::string_view reason = "");

/// @brief Check a whole number.
/// @throws InvalidInput unless it is at least `least` and at most `most`
void require_count(std::string_view name, int value, int least, int most, std::string_view reason = "");

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
