/// @file
/// @brief How a surface bends where another one touches it.
#pragma once

namespace viscoroll::detail {

/// @brief Of a surface, > 0 where it bulges, < 0 where it is hollow [1/m].
struct Curvatures {
  double along = 0.0;   ///< the path
  double across = 0.0;  ///< the path

  friend bool operator==(const Curvatures&, const Curvatures&) = default;
};

}  // namespace viscoroll::detail
