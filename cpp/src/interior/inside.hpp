/// @file
/// @brief Body whose interior is evaluated, with the speed at which its material passes the tractions.
#pragma once

#include "modal/layered_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Layers and the angular speed of their orders.
struct Inside {
  LayeredBody body;
  double angular_speed;  ///< order m has the frequency m Omega [rad/s]; the angular speed of the body if it rotates
};

/// @param[in] shape body with layers
/// @param[in] angular_speed Omega of the rolling body [rad/s], > 0
/// @param[in] radius radius of the rolling body [m], > 0, which converts wave numbers of a plane to orders
/// @param[in] line whether it is a line contact
/// @param[in] curvature curvature terms of a sphere: sphere or paper
/// @throws InvalidInput for bad input, for line contact of a sphere or wheel, and for point contact of a
/// cylinder
[[nodiscard]] Inside inside_of(const LayeredShape& shape, double angular_speed, double radius, bool line,
                               Curvature curvature);

/// @return same, for the given tractions, which are checked
[[nodiscard]] Inside inside_of(const LayeredShape& shape, double angular_speed, const Tractions& tractions);

}  // namespace viscoroll::detail
