/// @file
/// @brief What a layered body does under a spot, whatever body it is of those that are straight across.
#pragma once

#include "influence/order_bands.hpp"
#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @return the patches of what rolls, as the layers under it see them
[[nodiscard]] Patches patches_under(const LayeredBody& layers, const Crossing& crossing);

/// @return the nearest mesh of whole parts of a revolution, for the choice of orders
[[nodiscard]] Mesh nearest_mesh(const Patches& patches, const Mesh& mesh);

/// @param[in] layers of a plane, with the radius of what rolls, or as of a wheel; at least one
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] BodySurface surface_under_spot(const LayeredBody& layers, const Crossing& crossing);

}  // namespace viscoroll::detail
