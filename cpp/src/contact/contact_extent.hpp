/// @file
/// @brief Dimensions and largest pressure of a contact.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "surface/surface_window.hpp"

namespace viscoroll::detail {

/// @brief Dimensions and largest pressure of a contact. The members have the names of scalars of results and histories.
struct ContactExtent {
  double contact_area;          ///< [m^2]; for a line contact, per unit length [m]
  double contact_length;        ///< largest distance between the edges of a row along the path [m]
  double contact_length_error;  ///< relative uncertainty of these edges [-]
  /// Semi-axis of the ellipse with the same second moments; for a line contact, half the width [m].
  double semi_axis_x;
  std::optional<double> semi_axis_z;  ///< across the path [m]; empty for a line contact
  /// Width across the path, between the outer sides of the patches [m]; empty for a line contact.
  std::optional<double> contact_width;
  double max_pressure;  ///< largest pressure of a node [Pa]

  /// @brief Set the scalars of these names in a result or in an instant of a history. The latter has no width or error,
  /// and its undetermined dimensions are not a number.
  template <class Scalars>
  void copy_to(Scalars& scalars) const {
    scalars.contact_area = contact_area;
    scalars.contact_length = contact_length;
    scalars.semi_axis_x = semi_axis_x;
    scalars.max_pressure = max_pressure;
    if constexpr (requires { scalars.contact_width; }) {
      scalars.contact_length_error = contact_length_error;
      scalars.semi_axis_z = semi_axis_z;
      scalars.contact_width = contact_width;
    } else {
      scalars.semi_axis_z = semi_axis_z.value_or(std::numeric_limits<double>::quiet_NaN());
    }
  }
};

/// @param[in] nodes nodes of a window
/// @param[in] contact numbers of the nodes in contact, in ascending order
/// @param[in] touching area in contact around each of these nodes [m^2]
/// @param[in] pressure contact pressure of each of these nodes [Pa]
/// @param[in] center_z center of the contact across the path [m], if `nodes` covers only one side
[[nodiscard]] ContactExtent contact_extent(const SurfaceWindow& nodes, const std::vector<Eigen::Index>& contact,
                                           const Eigen::ArrayXd& touching, const Eigen::ArrayXd& pressure,
                                           std::optional<double> center_z = std::nullopt);

}  // namespace viscoroll::detail
