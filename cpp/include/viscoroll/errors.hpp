/// @file
/// @brief Exceptions of the library. Every public function throws `InvalidInput` for invalid input.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace viscoroll {

/// @brief A parameter has an invalid value. The message is "<parameter> <rule>, got <value>", for example
/// "layers[0].thickness must be > 0 m, got -1".
class InvalidInput : public std::invalid_argument {
 public:
  /// @param[in] parameter,rule,value see the members of the same name
  /// @param[in] more further errors of the same input, for the message; may be empty
  InvalidInput(const std::string& parameter, const std::string& rule, const std::string& value,
               const std::string& more = "");

  /// @return path of the parameter, for example "layers[0].thickness"
  [[nodiscard]] const std::string& parameter() const noexcept { return parameter_; }

  /// @return rule that the value violates, with range and unit, for example "must be > 0 m"
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }

  /// @return text of the given value; may be empty
  [[nodiscard]] const std::string& value() const noexcept { return value_; }

  /// @brief Return the same error for a parameter of a table.
  /// @param[in] table path of the table, for example "ball.layers[0]"; its last name is not repeated if the parameter
  /// begins with it
  [[nodiscard]] InvalidInput inside(std::string_view table) const;

 private:
  std::string parameter_;
  std::string rule_;
  std::string value_;
  std::string more_;
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
