/// @file
/// @brief Exceptions of the library. Every public function throws `InvalidInput` for invalid input.
#pragma once

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace viscoroll {

/// @brief Interval of the allowed values of a number.
struct Range {
  std::string unit = "";                                      ///< SI unit; empty for a pure number
  double minimum = -std::numeric_limits<double>::infinity();  ///< lower end, in `unit`
  double maximum = std::numeric_limits<double>::infinity();   ///< upper end, in `unit`
  bool excludes_minimum = false;                              ///< whether the lower end itself is not allowed
  bool excludes_maximum = false;                              ///< whether the upper end itself is not allowed

  /// @return whether the range contains a number; no range contains an infinite number or not-a-number
  [[nodiscard]] bool contains(double value) const noexcept;

  /// @return text of the range, such as "> 0 m", "<= 4" or "in [0, 1)"
  [[nodiscard]] std::string text() const;
};

/// @brief A parameter has an invalid value. The message is "<parameter> <rule>, got <value>", for example
/// "layers[0].thickness must be > 0 m, got -1".
class InvalidInput : public std::invalid_argument {
 public:
  /// @param[in] parameter,rule,value see the members of the same name
  /// @param[in] more further errors of the same input, for the message; may be empty
  /// @param[in] allowed see the member of the same name
  InvalidInput(const std::string& parameter, const std::string& rule, const std::string& value,
               const std::string& more = "", std::optional<Range> allowed = {});

  /// @return path of the parameter, for example "layers[0].thickness"
  [[nodiscard]] const std::string& parameter() const noexcept { return parameter_; }

  /// @return rule that the value violates, with range and unit, for example "must be > 0 m"
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }

  /// @return text of the given value; may be empty
  [[nodiscard]] const std::string& value() const noexcept { return value_; }

  /// @return unit and ends of the range that the value leaves, or nothing if the rule is not a range
  [[nodiscard]] const std::optional<Range>& allowed() const noexcept { return allowed_; }

  /// @brief Return the same error for a parameter of a table.
  /// @param[in] table path of the table, for example "ball.layers[0]"; its last name is not repeated if the parameter
  /// begins with it
  [[nodiscard]] InvalidInput inside(std::string_view table) const;

 private:
  std::string parameter_;
  std::string rule_;
  std::string value_;
  std::string more_;
  std::optional<Range> allowed_;
};

/// @brief An iteration ended without a usable result.
class ConvergenceError : public std::runtime_error {
 public:
  /// @param[in] message what the solver tried
  /// @param[in] iterations,residual see the members of the same name
  ConvergenceError(const std::string& message, int iterations, double residual)
      : std::runtime_error(message), iterations_(iterations), residual_(residual) {}

  /// @return number of iterations before the solver stopped
  [[nodiscard]] int iterations() const noexcept { return iterations_; }

  /// @return residual of the last iterate [-]; the message names the quantity to which it is relative
  [[nodiscard]] double residual() const noexcept { return residual_; }

 private:
  int iterations_;
  double residual_;
};

/// @brief The observer canceled a running computation.
class Canceled : public std::runtime_error {
 public:
  Canceled() : std::runtime_error("the observer canceled the solve") {}
};

}  // namespace viscoroll
