/// @file
/// @brief What a layered body does under a spot, whatever body it is of those that are straight across.
#pragma once

#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @param[in] layers of a plane, with the radius of what rolls, or as of a wheel; at least one
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] BodySurface surface_under_spot(const LayeredBody& layers, const Crossing& crossing);

}  // namespace viscoroll::detail
