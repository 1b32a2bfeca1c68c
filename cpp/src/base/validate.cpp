#include "base/validate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "viscoroll/errors.hpp"

namespace viscoroll {
namespace {

std::string message(const std::string& parameter, const std::string& rule, const std::string& value,
                    const std::string& more) {
  return parameter + " " + rule + (value.empty() ? "" : ", got " + value) + (more.empty() ? "" : "; " + more);
}

}  // namespace

InvalidInput::InvalidInput(const std::string& parameter, const std::string& rule, const std::string& value,
                           const std::string& more)
    : std::invalid_argument(message(parameter, rule, value, more)),
      parameter_(parameter),
      rule_(rule),
      value_(value),
      more_(more) {}

InvalidInput InvalidInput::inside(std::string_view table) const {
  const std::size_t dot = table.rfind('.');
  const std::string_view last = dot == std::string_view::npos ? table : table.substr(dot + 1);
  const std::string_view rest = std::string_view(parameter_).substr(std::min(last.size(), parameter_.size()));
  const bool repeated = parameter_.starts_with(last) && (rest.empty() || rest.front() == '.' || rest.front() == '[');
  const std::string above(table.substr(0, repeated ? table.size() - last.size() : table.size()));
  return {above + (repeated ? "" : ".") + parameter_, rule_, value_, more_};
}

}  // namespace viscoroll

namespace viscoroll::detail {

#if defined(__cpp_lib_to_chars)

std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string rounded(double value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3).ptr;
  return {buffer.data(), end};
}

#else

// Clang's standard library cannot print floating-point numbers by to_chars on macOS before 13.3, and for WebAssembly it
// needs 100 kB of tables for that.

namespace {

std::string printed(const char* format, int precision, double value) {
  std::array<char, 400> buffer{};  // the largest number has 309 digits
  const int length = std::snprintf(buffer.data(), buffer.size(), format, precision, value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace

/// Shortest text from which the number can be read back, with an exponent only if that is shorter.
std::string text(double value) {
  int after_point = 0;
  std::string scientific = printed("%.*e", after_point, value);
  while (after_point < std::numeric_limits<double>::max_digits10 - 1 &&
         std::strtod(scientific.c_str(), nullptr) != value) {
    scientific = printed("%.*e", ++after_point, value);
  }
  const std::size_t exponent = scientific.find('e');
  if (exponent == std::string::npos) return scientific;  // inf or nan
  const int decimals = after_point - std::stoi(scientific.substr(exponent + 1));
  std::string fixed = printed("%.*f", std::max(decimals, 0), value);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

std::string rounded(double value) { return printed("%.*g", 3, value); }

#endif

void reject(std::string_view name, std::string_view requirement, std::string_view value) {
  throw InvalidInput(std::string(name), "must be " + std::string(requirement), std::string(value));
}

void reject(std::string_view name, std::string_view requirement, double value) {
  reject(name, requirement, text(value));
}

namespace {

/// Value with its unit, such as "0 Pa", or the value alone if the unit is empty.
std::string with_unit(double value, std::string_view unit) {
  return unit.empty() ? text(value) : text(value) + " " + std::string(unit);
}

void require_at_most_largest(std::string_view name, double value, std::string_view unit) {
  if (value > kLargestNumber) reject(name, "at most " + with_unit(kLargestNumber, unit), value);
}

}  // namespace

void require_positive(std::string_view name, double value, std::string_view unit) {
  if (!(std::isfinite(value) && value > 0.0)) reject(name, "> " + with_unit(0.0, unit), value);
  if (value < kSmallestNumber) reject(name, "at least " + with_unit(kSmallestNumber, unit), value);
  require_at_most_largest(name, value, unit);
}

void require_nonnegative(std::string_view name, double value, std::string_view unit) {
  if (!(std::isfinite(value) && value >= 0.0)) reject(name, ">= " + with_unit(0.0, unit), value);
  require_at_most_largest(name, value, unit);
}

void require_length(std::string_view name, double value, double radius, std::string_view body) {
  const double least = radius / kLargestLengthRatio;
  if (value >= least) return;
  reject(name,
         "at least " + rounded(1.0 / kLargestLengthRatio) + " of the radius of " + std::string(body) + ", " +
             rounded(least) + " m",
         text(value) + " m");
}

void require_friction(double value) {
  if (value == std::numeric_limits<double>::infinity()) return;
  require_nonnegative("friction", value, "");
  if (value <= kLargestFriction) return;
  reject("friction",
         "at most " + text(kLargestFriction) + " (no pair of materials has more), or infinite for full stick", value);
}

void require_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) reject(name, "finite", value);
}

}  // namespace viscoroll::detail
