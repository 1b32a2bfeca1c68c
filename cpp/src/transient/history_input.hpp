/// @file
/// @brief What a history may be asked for.
#pragma once

#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

inline constexpr int kMostLattices = 16;

/// @brief Check options.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const HistoryOptions& options);

}  // namespace viscoroll::detail
