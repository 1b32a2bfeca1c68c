/// @file
/// @brief Surface of any layered body in line contact.
#pragma once

#include "modal/layered_body.hpp"
#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @brief Sum of the orders of a body in line contact.
/// @param[in] layers layers of a body, at least one; for a plane, with the radius of the rolling body
/// @param[in] kinematics motion of the material through the contact
[[nodiscard]] std::unique_ptr<const TableSum> sum_under_line(const LayeredBody& layers,
                                                             const ContactKinematics& kinematics);

/// @brief Properties of the surface of a body in line contact.
/// @param[in] layers same as in `sum_under_line`
/// @param[in] kinematics motion of the material through the contact
[[nodiscard]] BodySurface surface_under_line(const LayeredBody& layers, const ContactKinematics& kinematics);

}  // namespace viscoroll::detail
