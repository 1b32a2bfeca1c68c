/// @file
/// @brief What the equations ask of an inner boundary.
#pragma once

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief The two columns of inner_boundaries.def.
struct InnerSurface {
  bool is_core;  ///< a rigid core holds the layer, and excludes rigid motions
  bool is_free;  ///< nothing holds it

  /// @return whether there is a core or a cavity, which has a radius
  [[nodiscard]] constexpr bool exists() const { return is_core || is_free; }
};

[[nodiscard]] constexpr InnerSurface inner_surface(InnerBoundary boundary) {
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) \
  case InnerBoundary::name:                                             \
    return {is_core, is_free};
  switch (boundary) {
#include "viscoroll/inner_boundaries.def"
  }
#undef VISCOROLL_INNER_BOUNDARY
  return {true, false};
}

}  // namespace viscoroll::detail
