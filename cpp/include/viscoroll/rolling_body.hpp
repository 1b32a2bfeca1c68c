/// @file
/// @brief What rolls, and what it rolls on.
#pragma once

#include <variant>

#include "viscoroll/cylinder.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll {

/// @brief What rolls: a sphere, a wheel, or a roller in line contact, whose loads, forces, torques and powers are per
/// length.
using RollingBody = std::variant<CoatedSphere, CoatedCylinder, CoatedWheel>;

/// @brief What it rolls on: a plane, which is rigid without layers and base; for a ball or a wheel also a groove, or a
/// rail; for a roller or a wheel also another one, on an axis of its own, that turns the other way with the same
/// surface speed.
using Counterpart = std::variant<CoatedPlane, CoatedCylinder, Groove, CoatedWheel>;

}  // namespace viscoroll
