/// @file
/// @brief A stretch of a motion that some steps of have been taken.
#pragma once

#include <cstddef>
#include <optional>

#include "transient/numbers.hpp"
#include "transient/step_end.hpp"

namespace viscoroll::detail {

/// @brief From one knot to the next, as it was when its first step began: who goes on in the middle of it divides it
/// alike.
struct Stretch {
  StepEnd begin;
  StepEnd end;
  double last_step;   ///< before it [s]
  std::size_t taken;  ///< steps of it
};

void write(const std::optional<Stretch>& stretch, NumberWriter& numbers);

/// @throws std::invalid_argument where the numbers are others
[[nodiscard]] std::optional<Stretch> read_stretch(NumberReader& numbers);

}  // namespace viscoroll::detail
