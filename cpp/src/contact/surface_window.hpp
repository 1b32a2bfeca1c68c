/// @file
/// @brief The nodes of the candidate contact surface and their directions.
#pragma once

#include <Eigen/Core>
#include <array>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Consecutive nodes along a direction, counted from the lowest point.
struct NodeRange {
  int first;
  int last;  ///< the last one itself

  [[nodiscard]] int count() const { return last - first + 1; }
  friend bool operator==(const NodeRange&, const NodeRange&) = default;
};

/// @brief The sphere with its grid of nodes at equal spacings in phi and theta, one of them at the lowest point
/// phi = theta = pi/2.
struct SurfaceGrid {
  double radius;         ///< r_o [m]
  double phi_spacing;    ///< [rad]
  double theta_spacing;  ///< [rad]
};

/// @brief The nodes of a rectangle of the grid.
class SurfaceWindow {
 public:
  /// @param[in] grid all nodes
  /// @param[in] phi,theta nodes of the window, less than a quarter revolution from the lowest point
  SurfaceWindow(const SurfaceGrid& grid, NodeRange phi, NodeRange theta);

  [[nodiscard]] WindowShape shape() const { return {phi_range_.count(), theta_range_.count()}; }
  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] NodeRange phi_range() const { return phi_range_; }
  [[nodiscard]] NodeRange theta_range() const { return theta_range_; }

  /// @return whether another window of the same grid has the same nodes
  [[nodiscard]] bool covers_same(const SurfaceWindow& other) const {
    return phi_range_ == other.phi_range_ && theta_range_ == other.theta_range_;
  }

  /// @return the number, in this window, of the node of another one that has number `node` there; inside this window
  [[nodiscard]] Eigen::Index number_of(const SurfaceWindow& other, Eigen::Index node) const;

  /// Undeformed positions [m]: x forward, y down, z sideways.
  [[nodiscard]] const Eigen::ArrayXd& x() const { return x_; }
  [[nodiscard]] const Eigen::ArrayXd& y() const { return y_; }
  [[nodiscard]] const Eigen::ArrayXd& z() const { return z_; }
  /// @return height of every undeformed node above the lowest point, r_o - y without its round-off [m]
  [[nodiscard]] const Eigen::ArrayXd& height() const { return height_; }
  /// @return phi of every node [rad]
  [[nodiscard]] Eigen::ArrayXd phi() const;
  /// @return theta of every node [rad]
  [[nodiscard]] Eigen::ArrayXd theta() const;

  /// @return directions x (forward), y (down) and z (sideways), each by its components (r, phi, theta) at every node:
  /// the rows of the rotation Q of paper equation (40), where U = -x, V = -z and W = y
  [[nodiscard]] std::array<std::array<Eigen::ArrayXd, 3>, 3> axes() const;

 private:
  SurfaceGrid grid_;
  NodeRange phi_range_;
  NodeRange theta_range_;
  Eigen::ArrayXd x_, y_, z_, height_;
};

}  // namespace viscoroll::detail
