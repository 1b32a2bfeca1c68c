#include "base/validate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

#include "viscoroll/errors.hpp"

namespace viscoroll {
namespace {

std::string message(const std::string& parameter, const std::string& rule, const std::string& value,
                    const std::string& more) {
  return parameter + " " + rule + (value.empty() ? "" : ", got " + value) + (more.empty() ? "" : "; " + more);
}

}  // namespace

bool Range::contains(double value) const noexcept {
  return std::isfinite(value) && (excludes_minimum ? value > minimum : value >= minimum) &&
         (excludes_maximum ? value < maximum : value <= maximum);
}

std::string Range::text() const {
  const std::string after = unit.empty() ? "" : " " + unit;
  if (std::isinf(minimum) && std::isinf(maximum)) return "finite";
  if (std::isinf(maximum)) return (excludes_minimum ? "> " : ">= ") + detail::text(minimum) + after;
  if (std::isinf(minimum)) return (excludes_maximum ? "< " : "<= ") + detail::text(maximum) + after;
  return std::string("in ") + (excludes_minimum ? "(" : "[") + detail::text(minimum) + ", " + detail::text(maximum) +
         (excludes_maximum ? ")" : "]") + after;
}

InvalidInput::InvalidInput(const std::string& parameter, const std::string& rule, const std::string& value,
                           const std::string& more, std::optional<Range> allowed)
    : std::invalid_argument(message(parameter, rule, value, more)),
      parameter_(parameter),
      rule_(rule),
      value_(value),
      more_(more),
      allowed_(std::move(allowed)) {}

InvalidInput InvalidInput::inside(std::string_view table) const {
  const std::size_t dot = table.rfind('.');
  const std::string_view last = dot == std::string_view::npos ? table : table.substr(dot + 1);
  const std::string_view rest = std::string_view(parameter_).substr(std::min(last.size(), parameter_.size()));
  const bool repeated = parameter_.starts_with(last) && (rest.empty() || rest.front() == '.' || rest.front() == '[');
  const std::string above(table.substr(0, repeated ? table.size() - last.size() : table.size()));
  return {above + (repeated ? "" : ".") + parameter_, rule_, value_, more_, allowed_};
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

void reject(std::string_view name, std::string_view requirement, std::string_view value, std::optional<Range> range) {
  throw InvalidInput(std::string(name), "must be " + std::string(requirement), std::string(value), "",
                     std::move(range));
}

void reject(std::string_view name, std::string_view requirement, double value, std::optional<Range> range) {
  reject(name, requirement, text(value), std::move(range));
}

void reject(std::string_view name, const Range& range, std::string_view value, std::string_view reason) {
  reject(name, range.text() + std::string(reason), value, range);
}

void reject(std::string_view name, const Range& range, double value, std::string_view reason) {
  reject(name, range, text(value), reason);
}

void require_in(const Range& range, std::string_view name, double value, std::string_view reason) {
  if (!range.contains(value)) reject(name, range, value, reason);
}

void require_count(std::string_view name, int value, int least, int most, std::string_view reason) {
  if (value >= least && value <= most) return;
  const Range range{.minimum = static_cast<double>(least), .maximum = static_cast<double>(most)};
  reject(name, "in [" + std::to_string(least) + ", " + std::to_string(most) + "]" + std::string(reason),
         std::to_string(value), range);
}

void require_positive(std::string_view name, double value, std::string_view unit) {
  require_in({.unit = std::string(unit), .minimum = 0.0, .excludes_minimum = true}, name, value);
  require_in({.unit = std::string(unit), .minimum = kSmallestNumber}, name, value);
  require_in({.unit = std::string(unit), .maximum = kLargestNumber}, name, value);
}

void require_nonnegative(std::string_view name, double value, std::string_view unit) {
  require_in({.unit = std::string(unit), .minimum = 0.0}, name, value);
  require_in({.unit = std::string(unit), .maximum = kLargestNumber}, name, value);
}

void require_length(std::string_view name, double value, double radius, std::string_view body) {
  const double least = radius / kLargestLengthRatio;
  if (value >= least) return;
  reject(name,
         "at least " + rounded(1.0 / kLargestLengthRatio) + " of the radius of " + std::string(body) + ", " +
             rounded(least) + " m",
         text(value) + " m", Range{.unit = "m", .minimum = least});
}

void require_friction(double value) {
  if (value == std::numeric_limits<double>::infinity()) return;
  require_nonnegative("friction", value, "");
  require_in({.maximum = kLargestFriction}, "friction", value,
             " (no pair of materials has more), or infinite for full stick");
}

void require_finite(std::string_view name, double value) { require_in({}, name, value); }

}  // namespace viscoroll::detail
