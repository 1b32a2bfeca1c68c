/// @file
/// @brief What rolls.
#pragma once

#include <variant>

#include "viscoroll/cylinder.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief What rolls: a sphere, or a roller in line contact, whose loads, forces, torques and powers are per length.
using RollingBody = std::variant<CoatedSphere, CoatedCylinder>;

}  // namespace viscoroll
