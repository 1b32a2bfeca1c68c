/// @file
/// @brief From a solved contact to what a user asks for.
#pragma once

#include "rolling/window_search.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Torques, powers and fields of a solved contact.
[[nodiscard]] Result make_result(const Assembly& given, const HeldContact& held);

}  // namespace viscoroll::detail
