/// @file
/// @brief Positions of the nodes around the contact at an instant.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/surface_window.hpp"
#include "transient/step_operator.hpp"
#include "transient/viscoelastic_pair.hpp"

namespace viscoroll::detail {

/// @brief Rows of nodes around the lowest point. Row numbers continue as the body rolls: row I of both bodies meets at
/// the same place.
struct ContactPlace {
  Eigen::Index first;  ///< number of the first row
  Eigen::Index count;  ///< number of rows
  SurfaceWindow nodes;
  Eigen::ArrayXd weights;     ///< of the nodes, see `half_weights`
  Eigen::ArrayXd gap;         ///< between the undeformed bodies, 0 at the lowest point [m]
  Eigen::ArrayXd moment_arm;  ///< of the pressure; its moment is the rolling resistance [m]
  std::vector<Axes> axes;     ///< of every body; empty if pressure is radial and there is no friction
};

/// @return directions of the plane at the nodes of every body, same as in `ContactPlace`
[[nodiscard]] std::vector<Axes> axes_at(const ViscoelasticPair& pair, const SurfaceWindow& nodes);

/// @brief Rows around the lowest point at an angle.
/// @param[in] pair both bodies
/// @param[in] shift of the nodes at angle 0 [spacings]
/// @param[in] half_rows rows on either side of the lowest one
/// @param[in] angle turned [rad]
[[nodiscard]] ContactPlace place_at(const ViscoelasticPair& pair, double shift, Eigen::Index half_rows, double angle);

/// @brief Rows with given numbers and nodes.
/// @param[in] pair both bodies
/// @param[in] first number of the first row
/// @param[in] nodes nodes of the first row and those after it
[[nodiscard]] ContactPlace place_of(const ViscoelasticPair& pair, Eigen::Index first, SurfaceWindow nodes);

}  // namespace viscoroll::detail
