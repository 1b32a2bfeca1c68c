#include "validate.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace viscoroll::detail {

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

void require_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) reject(name, "finite", value);
}

}  // namespace viscoroll::detail
