/// @file
/// @brief Properties of an inner boundary that enter the layer equations.
#pragma once

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Properties of an inner boundary, from inner_boundaries.def.
struct InnerSurface {
  bool is_core;  ///< the layer is bonded to a rigid core, which excludes rigid motions
  bool is_free;  ///< the inner surface of the layer is free of stress

  /// @return whether there is a core or a cavity, and with it an inner radius
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
