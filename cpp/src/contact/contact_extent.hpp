/// @file
/// @brief Area, semi-axes and width of a contact.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/surface_window.hpp"

namespace viscoroll::detail {

struct ContactExtent {
  double area;  ///< contact area [m^2]; for a line contact, per unit length [m]
  /// Semi-axis of the ellipse with the same second moments; for a line contact, half the width [m].
  double semi_axis_x;
  std::optional<double> semi_axis_z;  ///< across the path [m]; empty for a line contact
  /// Width across the path, between the outer sides of the patches [m]; empty for a line contact.
  std::optional<double> width;
};

/// @param[in] nodes nodes of a window
/// @param[in] contact numbers of the nodes in contact
/// @param[in] touching area in contact around each of these nodes [m^2]
/// @param[in] center_z center of the contact across the path [m], if `nodes` covers only one side
[[nodiscard]] ContactExtent contact_extent(const SurfaceWindow& nodes, const std::vector<Eigen::Index>& contact,
                                           const Eigen::ArrayXd& touching,
                                           std::optional<double> center_z = std::nullopt);

}  // namespace viscoroll::detail
