/// @file
/// @brief The gap between two undeformed bodies, and the lever of the pressure that belongs to it:
/// See docs/theory/planes-and-pairs.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rolling/mesh_model.hpp"
#include "rolling/rolling_pair.hpp"
#include "surface/surface_window.hpp"

namespace viscoroll::detail {

/// @param[in] points nodes of what rolls
/// @param[in] swelling of the free surfaces, by the turning
/// @param[in] pair both bodies
/// @return at every node, 0 where the lowest one is [m]
[[nodiscard]] Eigen::ArrayXd initial_gap(const SurfaceWindow& points, const Swelling& swelling,
                                         const RollingPair& pair);

/// @brief By which share of the speed the surface that a body rolls on lags, where it turns too and is nearer to its
/// own axis: 0 of a straight one.
/// @return at every node [-]
[[nodiscard]] Eigen::ArrayXd counterpart_delay(const SurfaceWindow& points, const Swelling& swelling,
                                               const RollingPair& pair);

/// @brief What the moment of the pressure is made of: the relative radius times the slope of the undeformed gap along
/// the nodes.
/// @param[in] points nodes of what rolls
/// @param[in] pair both bodies
/// @return at every node [m]
[[nodiscard]] Eigen::ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair);
/// @return the same of some nodes
[[nodiscard]] Eigen::ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair,
                                            const std::vector<Eigen::Index>& nodes);

/// @return slope of what a body rolls on where it touches it, swollen but not deformed, downwards along the way of the
/// material, at every node [-]
[[nodiscard]] Eigen::ArrayXd counterpart_slope(const SurfaceWindow& points, const Swelling& swelling,
                                               const RollingPair& pair);
/// @return the same of some nodes
[[nodiscard]] Eigen::ArrayXd counterpart_slope(const SurfaceWindow& points, const Swelling& swelling,
                                               const RollingPair& pair, const std::vector<Eigen::Index>& nodes);

}  // namespace viscoroll::detail
