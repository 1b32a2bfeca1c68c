/// @file
/// @brief Curvatures of a surface at the contact.
#pragma once

namespace viscoroll::detail {

/// @brief Curvatures of a surface [1/m], positive if the surface is convex, negative if it is concave.
struct Curvatures {
  double along = 0.0;   ///< along the path
  double across = 0.0;  ///< across the path

  friend bool operator==(const Curvatures&, const Curvatures&) = default;
};

}  // namespace viscoroll::detail
