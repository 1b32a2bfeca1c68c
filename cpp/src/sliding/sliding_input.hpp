/// @file
/// @brief Input of sliding: checks, and the heights in the order of the solver.
#pragma once

#include <vector>

#include "sliding/sliding_symbol.hpp"
#include "viscoroll/sliding.hpp"

namespace viscoroll::detail {

/// @brief Check the layers under a rough surface.
/// @throws InvalidInput naming parameter, value, unit and range; also for a rigid plane
void validate_below(const CoatedPlane& on);

/// @brief Check the input of `slide`.
/// @throws InvalidInput naming parameter, value, unit and range
void validate_sliding(const HeightMap& map, const CoatedPlane& on, double pressure, double speed,
                      const SlidingOptions& options);

[[nodiscard]] SlidingPeriod period_of(const HeightMap& map);

/// @return heights in rows along xi, against the sliding direction [m]
[[nodiscard]] std::vector<double> heights_against_path(const HeightMap& map);

/// @brief Reverse the order of the rows of a field.
/// @param[in] values field, row by row
/// @param[in] columns length of a row
[[nodiscard]] std::vector<double> with_reversed_rows(const std::vector<double>& values, int columns);

}  // namespace viscoroll::detail
