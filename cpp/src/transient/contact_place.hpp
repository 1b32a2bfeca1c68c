/// @file
/// @brief Positions of the nodes around the contact at an instant.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/surface_window.hpp"
#include "transient/row_heights.hpp"
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
  RowHeights heights;         ///< of ground and tread at every row; empty if both are smooth
  double top = 0.0;           ///< largest sum of both heights in these rows [m]
  Eigen::ArrayXd gap;         ///< between the undeformed bodies; without heights, 0 at the lowest point [m]
  Eigen::ArrayXd moment_arm;  ///< of the pressure; its moment is the rolling resistance [m]
  std::vector<Axes> axes;     ///< of every body; empty if pressure is radial and there is no friction
};

/// @return values at the nodes of a half field, row by row, from one value for each row
[[nodiscard]] Eigen::ArrayXd at_nodes_of_rows(const Eigen::ArrayXd& rows, Eigen::Index half_nodes);

/// @return directions of the plane at the nodes of every body, same as in `ContactPlace`
[[nodiscard]] std::vector<Axes> axes_at(const ViscoelasticPair& pair, const SurfaceWindow& nodes);

/// @brief Rows around the lowest point at an angle.
/// @param[in] pair both bodies
/// @param[in] shift of the nodes at angle 0 [spacings]
/// @param[in] half_rows rows on either side of the lowest one
/// @param[in] angle turned [rad]
/// @param[in] ahead same as in `TrackRows`
[[nodiscard]] ContactPlace place_at(const ViscoelasticPair& pair, double shift, Eigen::Index half_rows, double angle,
                                    double ahead);

/// @brief Rows with given numbers and nodes.
/// @param[in] pair both bodies
/// @param[in] first number of the first row
/// @param[in] nodes nodes of the first row and those after it
/// @param[in] heights heights of these rows
[[nodiscard]] ContactPlace place_of(const ViscoelasticPair& pair, Eigen::Index first, SurfaceWindow nodes,
                                    RowHeights heights);

/// @brief Number of rows on either side of the lowest one that reach every point where the bodies could touch: a window
/// of them contains all rows whose undeformed gap is smaller than a limit.
/// @param[in] pair both bodies
/// @param[in] shift,angle,ahead same as in `place_at`
/// @param[in] limit largest undeformed gap of rows that could touch [m]
/// @return at most the number of rows up to 60 degrees; 0 if ground and tread are smooth
[[nodiscard]] Eigen::Index half_rows_in_reach(const ViscoelasticPair& pair, double shift, double angle, double ahead,
                                              double limit);

}  // namespace viscoroll::detail
