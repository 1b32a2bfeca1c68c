/// @file
/// @brief A body as tractions on its surface see it.
#pragma once

#include "modal/layered_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Layers, and how fast their material crosses the contact.
struct Inside {
  LayeredBody body;
  double angular_speed;  ///< by which order m has the frequency m Omega [rad/s]: that of the body, if it turns
};

/// @param[in] shape with layers
/// @param[in] angular_speed Omega of what rolls [rad/s], > 0
/// @param[in] radius of what rolls [m], > 0, which makes wave numbers of a plane orders
/// @param[in] line whether it touches along a line
/// @param[in] curvature of a sphere: sphere or paper
/// @throws std::invalid_argument for bad input, and for a line on a sphere or a wheel or a spot on a cylinder
[[nodiscard]] Inside inside_of(const LayeredShape& shape, double angular_speed, double radius, bool line,
                               Curvature curvature);

/// @return the same of checked tractions
[[nodiscard]] Inside inside_of(const LayeredShape& shape, double angular_speed, const Tractions& tractions);

}  // namespace viscoroll::detail
