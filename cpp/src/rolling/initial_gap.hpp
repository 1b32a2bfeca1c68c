/// @file
/// @brief The gap between two undeformed bodies, and the lever of the pressure that belongs to it: theory.md
/// section 15.
#pragma once

#include <Eigen/Core>

#include "rolling/rolling_body.hpp"
#include "surface/surface_window.hpp"

namespace viscoroll::detail {

/// @brief How far what a body rolls on lies below its highest point: a roller does, a groove rises.
/// @param[in] points nodes of what rolls
/// @param[in] on what it rolls on
/// @return at every node [m]
[[nodiscard]] Eigen::ArrayXd counterpart_drop(const SurfaceWindow& points, const Counterpart& on);

/// @brief By which share of the speed the surface that a body rolls on lags, where it turns too and is nearer to its
/// own axis: 0 of a straight one.
/// @return at every node [-]
[[nodiscard]] Eigen::ArrayXd counterpart_delay(const SurfaceWindow& points, const RollingPair& pair);

/// @brief What the moment of the pressure is made of: the relative radius times the slope of the undeformed gap along
/// the nodes.
/// @param[in] points nodes of what rolls
/// @param[in] pair both bodies
/// @return at every node [m]
[[nodiscard]] Eigen::ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair);

}  // namespace viscoroll::detail
