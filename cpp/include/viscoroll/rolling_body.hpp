/// @file
/// @brief What rolls, and what it rolls on.
#pragma once

#include <variant>

#include "viscoroll/cylinder.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief What rolls: a sphere, or a roller in line contact, whose loads, forces, torques and powers are per length.
using RollingBody = std::variant<CoatedSphere, CoatedCylinder>;

/// @brief What it rolls on: a plane, which is rigid without layers and base; a groove; or another one of
/// its kind, on an axis of its own, that turns the other way with the same surface speed.
using Counterpart = std::variant<CoatedPlane, CoatedCylinder, Groove, CoatedSphere>;

}  // namespace viscoroll
