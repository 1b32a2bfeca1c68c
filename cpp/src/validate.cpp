#include "validate.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace viscoroll::detail {

// The library of Clang does not say so until it can read such numbers, too; Emscripten's writes them.
#if defined(__cpp_lib_to_chars) || defined(__EMSCRIPTEN__)

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

#else  // macOS before 13.3 cannot do this to floating-point numbers, and its library does not know the systems

namespace {

std::string digits(double value, int count) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.*g", count, value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace

/// The fewest digits that are this number.
std::string text(double value) {
  for (int count = 1; count < std::numeric_limits<double>::max_digits10; ++count) {
    std::string shorter = digits(value, count);
    if (std::strtod(shorter.c_str(), nullptr) == value) return shorter;
  }
  return digits(value, std::numeric_limits<double>::max_digits10);
}

std::string rounded(double value) { return digits(value, 3); }

#endif

void reject(std::string_view name, std::string_view requirement, std::string_view value) {
  throw std::invalid_argument(std::string(name) + " must be " + std::string(requirement) + ", got " +
                              std::string(value));
}

void reject(std::string_view name, std::string_view requirement, double value) {
  reject(name, requirement, text(value));
}

namespace {

/// "0 Pa", or "0" of a number without unit.
std::string zero_of(std::string_view unit) { return unit.empty() ? "0" : "0 " + std::string(unit); }

}  // namespace

void require_positive(std::string_view name, double value, std::string_view unit) {
  if (!(std::isfinite(value) && value > 0.0)) reject(name, "> " + zero_of(unit), value);
}

void require_nonnegative(std::string_view name, double value, std::string_view unit) {
  if (!(std::isfinite(value) && value >= 0.0)) reject(name, ">= " + zero_of(unit), value);
}

void require_friction(double value) {
  if (value == std::numeric_limits<double>::infinity()) return;
  require_nonnegative("friction", value, "");
  if (value <= kLargestFriction) return;
  reject("friction",
         "at most " + text(kLargestFriction) +
             ", for no pair of materials has more, or infinite, where all of the contact sticks",
         value);
}

void require_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) reject(name, "finite", value);
}

}  // namespace viscoroll::detail
