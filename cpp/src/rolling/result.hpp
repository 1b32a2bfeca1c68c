/// @file
/// @brief Results of a solved contact in the form that users read.
#pragma once

#include "rolling/window_search.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @return extent of the nodes in contact
[[nodiscard]] ContactReach contact_reach(const Result& result);

/// @return extent of the nodes in contact and of the cohesive zone
[[nodiscard]] ContactReach loaded_reach(const Result& result);

/// @return extent of the patches of the nodes in contact, which end half a spacing beyond these nodes
[[nodiscard]] ContactReach reach_of_patches(const Result& result, const SurfaceGrid& grid);

/// @brief Compute torques, powers and fields of a solved contact.
[[nodiscard]] Result make_result(const ContactSetup& given, const WindowContact& solved);

}  // namespace viscoroll::detail
