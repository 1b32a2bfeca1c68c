/// @file
/// @brief What a layered body does along a line, whatever body it is.
#pragma once

#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @param[in] layers of a body, at least one; those of a plane with the radius of what rolls
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] std::unique_ptr<const TableSum> sum_under_line(const LayeredBody& layers, const Crossing& crossing);

/// @param[in] layers of a body, at least one; those of a plane with the radius of what rolls
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] BodySurface surface_under_line(const LayeredBody& layers, const Crossing& crossing);

}  // namespace viscoroll::detail
