#include "contact/surface_window.hpp"

#include <numbers>

namespace viscoroll::detail {

SurfaceWindow::SurfaceWindow(double radius, double spacing, int half_phi, int half_theta)
    : radius_(radius), spacing_(spacing), half_phi_(half_phi), half_theta_(half_theta) {
  const Eigen::Index count = shape().size();
  phi_.resize(count);
  theta_.resize(count);
  x_.resize(count);
  y_.resize(count);
  z_.resize(count);
  Eigen::Index node = 0;
  for (int i = -half_phi; i <= half_phi; ++i) {
    for (int k = -half_theta; k <= half_theta; ++k, ++node) {
      // Sines of the offsets from pi/2 keep the mirror symmetry to the last bit.
      const double forward = -i * spacing;  // pi/2 - phi
      const double sideways = -k * spacing;
      phi_[node] = std::numbers::pi / 2.0 - forward;
      theta_[node] = std::numbers::pi / 2.0 - sideways;
      x_[node] = radius * std::cos(sideways) * std::sin(forward);
      y_[node] = radius * std::cos(sideways) * std::cos(forward);
      z_[node] = radius * std::sin(sideways);
    }
  }
}

std::array<std::array<Eigen::ArrayXd, 3>, 3> SurfaceWindow::axes() const {
  return {{{x_ / radius_, -phi_.sin(), z_ / radius_ * phi_.cos()},
           {y_ / radius_, phi_.cos(), z_ / radius_ * phi_.sin()},
           {z_ / radius_, Eigen::ArrayXd::Zero(phi_.size()), -theta_.sin()}}};
}

}  // namespace viscoroll::detail
