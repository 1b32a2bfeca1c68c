/// @file
/// @brief What spheres and rollers have in common.
#pragma once

#include <string_view>
#include <vector>

#include "viscoroll/rolling_body.hpp"

namespace viscoroll::detail {

[[nodiscard]] double outer_radius(const RollingBody& body);
[[nodiscard]] double coating_thickness(const RollingBody& body);
[[nodiscard]] const std::vector<Layer>& layers(const RollingBody& body);

/// @return whether the contact is a line, and loads are per length
[[nodiscard]] bool is_roller(const RollingBody& body);

/// @return its name in messages
[[nodiscard]] std::string_view name(const RollingBody& body);
/// @return unit of its load
[[nodiscard]] std::string_view load_unit(const RollingBody& body);

}  // namespace viscoroll::detail
