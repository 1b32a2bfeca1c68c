/// @file
/// @brief Layers under a surface of finite size, free around it.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/table.hpp"
#include "surface/surface_operator.hpp"
#include "viscoroll/sliding.hpp"

namespace viscoroll::detail {

/// @brief Influence of forces on the nodes of a map on the layers under it. The layers extend beyond the map, where
/// their surface is free. Rows follow one another along xi, against the sliding direction.
class FiniteSurface {
 public:
  /// @param[in] map checked map
  /// @param[in] on checked plane, not rigid
  /// @param[in] speed sliding speed [m/s], >= 0
  /// @param[in] friction Coulomb's coefficient at the interface, >= 0: the friction, this multiple of the pressure,
  /// also displaces the surface
  /// @param[in] execution threads, progress and cancellation
  FiniteSurface(const HeightMap& map, const CoatedPlane& on, double speed, double friction, const Execution& execution);

  /// @return displacement due to pressure and friction
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> displacement() const { return displacement_; }

  /// @param[in] pressing force on every node [N], per length of a profile [N/m]
  /// @return work of the pressure at the displacement due to pressure and friction, per distance [N]
  [[nodiscard]] double work_of_pressure(const Eigen::ArrayXd& pressing) const { return work(pressing, pressed_); }
  /// @param[in] pressing same as above
  /// @return work dissipated in the layers per distance [N]
  [[nodiscard]] double loss(const Eigen::ArrayXd& pressing) const { return work(pressing, lost_); }

  /// @param[in] values values at the nodes, row by row
  /// @return mean slopes along xi over the patches
  [[nodiscard]] Eigen::ArrayXd slope_along(const Eigen::ArrayXd& values) const;

 private:
  using Tables = std::shared_ptr<const std::vector<Table>>;

  [[nodiscard]] double work(const Eigen::ArrayXd& pressing, const Tables& tables) const;

  double radius_;  // that converts wave numbers to orders [m]
  std::shared_ptr<const SurfaceOperator> displacement_;
  Tables pressed_;
  Tables lost_;
};

}  // namespace viscoroll::detail
