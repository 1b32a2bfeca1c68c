/// @file
/// @brief Messages for values out of range: parameter, requirement with unit, and the value that was given.
#pragma once

#include <string>
#include <string_view>

namespace viscoroll::detail {

/// @return the shortest decimal text that reads back as `value`
[[nodiscard]] std::string text(double value);

/// @return decimal text of three significant digits
[[nodiscard]] std::string rounded(double value);

/// @brief Refuse a value: "<name> must be <requirement>, got <value>".
/// @throws std::invalid_argument always
[[noreturn]] void reject(std::string_view name, std::string_view requirement, std::string_view value);
[[noreturn]] void reject(std::string_view name, std::string_view requirement, double value);

/// Range of positive numbers in SI units: the seventh power of one of them is still finite, as products of several
/// must be. No length, time, modulus or load in the laboratory comes near.
inline constexpr double kSmallestNumber = 1e-40;
inline constexpr double kLargestNumber = 1e40;

/// @param[in] unit empty for a number without one
/// @throws std::invalid_argument unless `value` is > 0 and in the range of positive numbers
void require_positive(std::string_view name, double value, std::string_view unit);

/// @throws std::invalid_argument unless `value` is finite, >= 0 and not above the range of positive numbers
void require_nonnegative(std::string_view name, double value, std::string_view unit);

/// Largest ratio of two lengths of a body. The places of boundaries are stored from the center, to 1e-16 of the radius,
/// which leaves seven digits of the thickness of a layer this thin.
inline constexpr double kLargestLengthRatio = 1e9;

/// @param[in] value length of a body [m]
/// @param[in] radius of the body that `body` names [m]
/// @throws std::invalid_argument unless `value` is long enough beside `radius`
void require_length(std::string_view name, double value, double radius, std::string_view body);

/// Coefficient of friction that no pair of materials exceeds [-].
inline constexpr double kLargestFriction = 4.0;

/// @throws std::invalid_argument unless `value` is a coefficient of friction that a pair of materials may have, or
/// infinite, where all of the contact sticks
void require_friction(double value);

/// @throws std::invalid_argument unless `value` is finite
void require_finite(std::string_view name, double value);

}  // namespace viscoroll::detail
