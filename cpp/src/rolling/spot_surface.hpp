/// @file
/// @brief What a layered body does under a spot: its tables, and all of it for the bodies that are straight across.
#pragma once

#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @param[in] layers of any body; those of a plane with the radius of what rolls; at least one
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] std::unique_ptr<const TableSum> sum_under_spot(const LayeredBody& layers, const Crossing& crossing);

/// @param[in] layers of a plane, with the radius of what rolls, or as of a wheel; at least one
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] BodySurface surface_under_spot(const LayeredBody& layers, const Crossing& crossing);

}  // namespace viscoroll::detail
