/// @file
/// @brief How large a contact is.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/surface_window.hpp"

namespace viscoroll::detail {

struct ContactExtent {
  double area;                        ///< [m^2], of a line per length [m]
  double semi_axis_x;                 ///< of the ellipse with its second moments; half of the width of a line [m]
  std::optional<double> semi_axis_z;  ///< likewise; a line has none
  std::optional<double> width;        ///< across the path, from patch to patch [m]; a line has none
};

/// @param[in] nodes of a window
/// @param[in] contact those of them that touch
/// @param[in] touching area in contact around each of these [m^2]
/// @param[in] center_z where the contact's center is across the path, if the nodes are of one side alone [m]
[[nodiscard]] ContactExtent contact_extent(const SurfaceWindow& nodes, const std::vector<Eigen::Index>& contact,
                                           const Eigen::ArrayXd& touching,
                                           std::optional<double> center_z = std::nullopt);

}  // namespace viscoroll::detail
