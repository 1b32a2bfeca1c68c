/// @file
/// @brief Where the nodes around the contact are, at an instant.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/surface_window.hpp"
#include "transient/creeping_pair.hpp"
#include "transient/plane_frame.hpp"

namespace viscoroll::detail {

/// @brief Rows of nodes around the lowest point. Their numbers go on as it rolls: row I is that of either body which
/// meets there.
struct ContactPlace {
  Eigen::Index first;  ///< row
  Eigen::Index count;  ///< of rows
  SurfaceWindow nodes;
  Eigen::ArrayXd gap;      ///< between the undeformed bodies, 0 at the lowest point [m]
  Eigen::ArrayXd lever;    ///< of the pressure, whose moment is the rolling resistance [m]
  std::vector<Axes> axes;  ///< of every body; empty ones where pressure is radial and there is no friction
};

/// @return directions of the plane at the nodes, of every body as in `ContactPlace`
[[nodiscard]] std::vector<Axes> axes_at(const CreepingPair& pair, const SurfaceWindow& nodes);

/// @param[in] pair both bodies
/// @param[in] shift of the nodes at angle 0 [spacings]
/// @param[in] half_rows rows on either side of the lowest one
/// @param[in] angle turned [rad]
[[nodiscard]] ContactPlace place_at(const CreepingPair& pair, double shift, Eigen::Index half_rows, double angle);

/// @param[in] pair both bodies
/// @param[in] first row
/// @param[in] nodes of it and those after it
[[nodiscard]] ContactPlace place_of(const CreepingPair& pair, Eigen::Index first, SurfaceWindow nodes);

}  // namespace viscoroll::detail
