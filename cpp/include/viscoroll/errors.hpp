/// @file
/// @brief Exceptions of the library. Bad input is `std::invalid_argument`, thrown by every public entry.
#pragma once

#include <stdexcept>
#include <string>

namespace viscoroll {

/// @brief An iteration ended without a usable answer.
class ConvergenceError : public std::runtime_error {
 public:
  /// @param[in] message what was tried
  /// @param[in] iterations,residual as below
  ConvergenceError(const std::string& message, int iterations, double residual)
      : std::runtime_error(message), iterations_(iterations), residual_(residual) {}

  /// @return iterations spent before giving up
  [[nodiscard]] int iterations() const noexcept { return iterations_; }

  /// @return residual of the last iterate [-], relative to what the message says
  [[nodiscard]] double residual() const noexcept { return residual_; }

 private:
  int iterations_;
  double residual_;
};

/// @brief The observer of a running solve asked it to stop.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("the solve was cancelled by its observer") {}
};

}  // namespace viscoroll
