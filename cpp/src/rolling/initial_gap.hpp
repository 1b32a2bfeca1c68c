/// @file
/// @brief Gap between two undeformed bodies, and the moment arm of the pressure that belongs to it: see
/// docs/theory/planes-and-pairs.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rolling/mesh_model.hpp"
#include "surface/surface_window.hpp"

namespace viscoroll::detail {

/// @brief Gap between the undeformed bodies.
/// @param[in] points nodes of the rolling body
/// @param[in] growth centrifugal growth of the free surfaces
/// @param[in] pair both bodies
/// @return gap of every node, 0 at the lowest one [m]
[[nodiscard]] Eigen::ArrayXd initial_gap(const SurfaceWindow& points, const CentrifugalGrowth& growth,
                                         const RollingPair& pair);

/// @brief Fraction of the speed by which the surface of the counterbody lags if the counterbody turns: a node nearer to
/// the axis of the counterbody is slower. The lag is 0 for a straight counterbody.
/// @return lag of every node [-]
[[nodiscard]] Eigen::ArrayXd counterbody_delay(const SurfaceWindow& points, const CentrifugalGrowth& growth,
                                               const RollingPair& pair);

/// @brief Moment arm of the pressure: the relative radius times the slope of the undeformed gap along the nodes.
/// @param[in] points nodes of the rolling body
/// @param[in] pair both bodies
/// @return moment arm of every node [m]
[[nodiscard]] Eigen::ArrayXd pressure_moment_arm(const SurfaceWindow& points, const RollingPair& pair);
/// @return the same for some nodes [m]
[[nodiscard]] Eigen::ArrayXd pressure_moment_arm(const SurfaceWindow& points, const RollingPair& pair,
                                                 const std::vector<Eigen::Index>& nodes);

/// @return slope of the counterbody's surface where a node of the rolling body meets it, with centrifugal growth but
/// without deformation, downwards in the direction in which material passes, at every node [-]
[[nodiscard]] Eigen::ArrayXd counterbody_slope(const SurfaceWindow& points, const CentrifugalGrowth& growth,
                                               const RollingPair& pair);
/// @return the same for some nodes [-]
[[nodiscard]] Eigen::ArrayXd counterbody_slope(const SurfaceWindow& points, const CentrifugalGrowth& growth,
                                               const RollingPair& pair, const std::vector<Eigen::Index>& nodes);

}  // namespace viscoroll::detail
