/// @file
/// @brief The rolling body and the counterbody.
#pragma once

#include <variant>

#include "viscoroll/cylinder.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll {

/// @brief The rolling body: a ball, a wheel, or a roller. A roller is in line contact; its loads, forces, torques and
/// powers are per unit length.
using RollingBody = std::variant<CoatedSphere, CoatedCylinder, CoatedWheel>;

/// @brief The counterbody.
///
/// Every body can roll on a plane, a groove, or a body of its own kind; a wheel can also roll on a roller. A plane or
/// groove without layers and base is rigid. A ball, roller or wheel as counterbody turns about an axis of its own in
/// the opposite sense, with the same surface speed.
using Counterbody = std::variant<CoatedPlane, CoatedCylinder, Groove, CoatedSphere, CoatedWheel>;

}  // namespace viscoroll
