/// @file
/// @brief The nodes of the candidate contact surface and their directions.
#pragma once

#include <Eigen/Core>
#include <array>

#include "influence/convolution.hpp"

namespace viscoroll::detail {

/// @brief Nodes at equal spacings in phi and theta around the lowest point phi = theta = pi/2, which is one of them.
class SurfaceWindow {
 public:
  /// @param[in] radius r_o [m]
  /// @param[in] spacing Delta [rad]
  /// @param[in] half_phi,half_theta nodes on either side of the lowest point, less than a quarter revolution
  SurfaceWindow(double radius, double spacing, int half_phi, int half_theta);

  [[nodiscard]] WindowShape shape() const { return {2 * half_phi_ + 1, 2 * half_theta_ + 1}; }
  [[nodiscard]] int half_phi() const { return half_phi_; }
  [[nodiscard]] int half_theta() const { return half_theta_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double spacing() const { return spacing_; }

  /// Undeformed positions [m]: x forward, y down, z sideways.
  [[nodiscard]] const Eigen::ArrayXd& x() const { return x_; }
  [[nodiscard]] const Eigen::ArrayXd& y() const { return y_; }
  [[nodiscard]] const Eigen::ArrayXd& z() const { return z_; }
  /// @return theta of every node [rad]
  [[nodiscard]] const Eigen::ArrayXd& theta() const { return theta_; }

  /// @return directions x (forward), y (down) and z (sideways), each by its components (r, phi, theta) at every node:
  /// the rows of the rotation Q of paper equation (40), where U = -x, V = -z and W = y
  [[nodiscard]] std::array<std::array<Eigen::ArrayXd, 3>, 3> axes() const;

 private:
  double radius_;
  double spacing_;
  int half_phi_;
  int half_theta_;
  Eigen::ArrayXd phi_, theta_, x_, y_, z_;
};

}  // namespace viscoroll::detail
