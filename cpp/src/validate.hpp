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

/// @param[in] unit empty for a number without one
/// @throws std::invalid_argument unless `value` is finite and > 0
void require_positive(std::string_view name, double value, std::string_view unit);

/// @throws std::invalid_argument unless `value` is finite and >= 0
void require_nonnegative(std::string_view name, double value, std::string_view unit);

/// Coefficient of friction that no pair of materials exceeds [-].
inline constexpr double kLargestFriction = 4.0;

/// @throws std::invalid_argument unless `value` is a coefficient of friction that a pair of materials may have, or
/// infinite, where all of the contact sticks
void require_friction(double value);

/// @throws std::invalid_argument unless `value` is finite
void require_finite(std::string_view name, double value);

}  // namespace viscoroll::detail
