/// @file
/// @brief Surface of any layered body in point or line contact.
#pragma once

#include <memory>

#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @brief Sum of the orders of a body.
/// @param[in] layers layers of a body, at least one; for a plane, with the radius of the rolling body
/// @param[in] kinematics motion of the material through the contact
[[nodiscard]] std::unique_ptr<const TableSum> sum_of_orders(const LayeredBody& layers,
                                                            const ContactKinematics& kinematics);

/// @brief Properties of the surface of a body.
/// @param[in] layers same as in `sum_of_orders`
/// @param[in] kinematics motion of the material through the contact
[[nodiscard]] BodySurface surface_of_layers(const LayeredBody& layers, const ContactKinematics& kinematics);

/// @brief Same as above, with other tables than those of `sum_of_orders`.
[[nodiscard]] BodySurface surface_of_layers(const LayeredBody& layers, const ContactKinematics& kinematics,
                                            std::unique_ptr<const SurfaceTables> tables);

}  // namespace viscoroll::detail
