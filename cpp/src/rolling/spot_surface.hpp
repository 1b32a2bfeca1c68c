/// @file
/// @brief What a layered body does under a spot.
#pragma once

#include <memory>

#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @param[in] layers of any body; those of a plane with the radius of what rolls; at least one
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] std::unique_ptr<const TableSum> sum_under_spot(const LayeredBody& layers, const Crossing& crossing);

/// @param[in] layers as for `sum_under_spot`
/// @param[in] crossing how its material crosses the contact
[[nodiscard]] BodySurface surface_under_spot(const LayeredBody& layers, const Crossing& crossing);

/// @brief The same with other tables than those of that sum.
[[nodiscard]] BodySurface surface_under_spot(const LayeredBody& layers, const Crossing& crossing,
                                             std::unique_ptr<const SurfaceTables> tables);

}  // namespace viscoroll::detail
