/// @file
/// @brief Exceptions of the library. Every public function throws `std::invalid_argument` for invalid input.
#pragma once

#include <stdexcept>
#include <string>

namespace viscoroll {

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
