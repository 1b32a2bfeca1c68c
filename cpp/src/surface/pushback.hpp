/// @file
/// @brief What pressure does along a deformed surface.
#pragma once

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief What `SurfaceOperator::pushback` is for a displacement, by differences between nodes.
/// @param[in] displacement of the counterpart at every node [m]
/// @param[in] force on every node [N]
/// @param[in] row nodes in a row
/// @param[in] distance from row to row [m]
/// @return [N]
[[nodiscard]] double pushback_by(const VectorField& displacement, const VectorField& force, Eigen::Index row,
                                 double distance);

}  // namespace viscoroll::detail
