#include "surface/surface_window.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "modal/circle.hpp"

namespace viscoroll::detail {
namespace {

/// Sine and cosine of an angle, and 1 - cosine without round-off.
struct Angle {
  explicit Angle(double angle) : sine(std::sin(angle)), cosine(std::cos(angle)) {
    const double half = std::sin(0.5 * angle);
    versine = 2.0 * half * half;
  }
  double sine;
  double cosine;
  double versine;
};

/// The nodes at one distance from the middle, which lie on a circle about the axis of rolling.
struct Circle {
  double z;       ///< sideways [m]
  double radius;  ///< [m]
  double drop;    ///< below the largest one [m]
};

Circle circle_at(const SurfaceGrid& grid, int column) {
  if (!grid.crown_radius) {
    // Sines of the offsets from pi/2 keep the mirror symmetry to the last bit.
    const Angle sideways(-column * grid.theta_spacing);  // pi/2 - theta
    return {.z = grid.radius * sideways.sine,
            .radius = grid.radius * sideways.cosine,
            .drop = grid.radius * sideways.versine};
  }
  const double z = -column * grid.theta_spacing * grid.radius;
  const double drop = drop_of_circle(z, 1.0 / *grid.crown_radius);
  return {.z = z, .radius = grid.radius - drop, .drop = drop};
}

}  // namespace

SurfaceWindow::SurfaceWindow(const SurfaceGrid& grid, const Window& window, double shift)
    : grid_(grid), window_(window), shift_(shift) {
  const auto& [phi, theta] = window;
  const Eigen::Index count = shape().size();
  x_.resize(count);
  y_.resize(count);
  z_.resize(count);
  height_.resize(count);
  std::vector<Circle> circles;
  for (int k = theta.first; k <= theta.last; ++k) circles.push_back(circle_at(grid, k));
  Eigen::Index node = 0;
  for (int i = phi.first; i <= phi.last; ++i) {
    const Angle forward(-(i + shift) * grid.phi_spacing);  // pi/2 - phi
    for (const Circle& circle : circles) {
      x_[node] = circle.radius * forward.sine;
      y_[node] = circle.radius * forward.cosine;
      z_[node] = circle.z;
      height_[node] = circle.drop + circle.radius * forward.versine;
      ++node;
    }
  }
  if (grid.is_paraboloid) flatten();
}

void SurfaceWindow::flatten() {
  const double r = grid_.radius;
  const Eigen::Index columns = shape().theta_nodes;
  for (Eigen::Index node = 0; node < x_.size(); ++node) {
    const Eigen::Index row = window_.phi.first + node / columns;
    const Eigen::Index column = window_.theta.first + node % columns;
    x_[node] = -r * grid_.phi_spacing * (static_cast<double>(row) + shift_);
    z_[node] = -r * grid_.theta_spacing * static_cast<double>(column);
  }
  height_ = (x_.square() + z_.square()) / (2.0 * r);
  y_ = r - height_;
}

Eigen::ArrayXd SurfaceWindow::lag() const {
  const Eigen::Index columns = shape().theta_nodes;
  const double step = grid_.phi_spacing;
  const double chord = 2.0 * std::sin(0.5 * step);
  Eigen::ArrayXd lag = Eigen::ArrayXd::Zero(shape().size());
  for (Eigen::Index node = columns; node < lag.size(); ++node) {
    const Eigen::Index row = window_.phi.first + node / columns;
    const double middle = (static_cast<double>(row) + shift_ - 0.5) * step;
    const int column = window_.theta.first + static_cast<int>(node % columns);
    if (grid_.is_paraboloid) {
      const double theta = column * grid_.theta_spacing;
      lag[node] = 0.5 * grid_.radius * step * (std::pow(middle, 2) + std::pow(theta, 2) + std::pow(step, 2) / 12.0);
      continue;
    }
    const Angle forward(middle);
    const Circle circle = circle_at(grid_, column);
    lag[node] = step * circle.drop + circle.radius * (step - chord + chord * forward.versine);
  }
  return lag;
}

Eigen::ArrayXd SurfaceWindow::rolled() const {
  if (!grid_.is_paraboloid) return x_;
  return x_ * (1.0 - (x_.square() / 3.0 + z_.square()) / (2.0 * std::pow(grid_.radius, 2)));
}

Eigen::ArrayXd SurfaceWindow::patch_area() const {
  const double equatorial = std::pow(grid_.radius, 2) * grid_.phi_spacing * grid_.theta_spacing;
  if (grid_.is_paraboloid || grid_.crown_radius) return Eigen::ArrayXd::Constant(shape().size(), equatorial);
  return equatorial * theta().sin();
}

Eigen::ArrayXd SurfaceWindow::phi() const {
  const Eigen::Index columns = shape().theta_nodes;
  return Eigen::ArrayXd::NullaryExpr(shape().size(), [&](Eigen::Index node) {
    const Eigen::Index row = window_.phi.first + node / columns;
    return std::numbers::pi / 2.0 + (static_cast<double>(row) + shift_) * grid_.phi_spacing;
  });
}

Eigen::ArrayXd SurfaceWindow::theta() const {
  const Eigen::Index columns = shape().theta_nodes;
  return Eigen::ArrayXd::NullaryExpr(shape().size(), [&](Eigen::Index node) {
    return std::numbers::pi / 2.0 + static_cast<double>(window_.theta.first + node % columns) * grid_.theta_spacing;
  });
}

std::array<std::array<Eigen::ArrayXd, 3>, 3> SurfaceWindow::axes() const {
  const Eigen::ArrayXd phi = this->phi();
  const Eigen::ArrayXd tilt = z_ / grid_.radius_across();  // the normal's share along z
  // The other share is the sine of theta, by which a sphere's circles are smaller, too.
  Eigen::ArrayXd level = theta().sin();
  Eigen::ArrayXd circle = Eigen::ArrayXd::Constant(phi.size(), grid_.radius);
  if (grid_.crown_radius) {
    level = (1.0 - tilt.square()).sqrt();
    circle = (grid_.radius - height_) / phi.sin() / level;
  }
  return {{{x_ / circle, -phi.sin(), tilt * phi.cos()},
           {y_ / circle, phi.cos(), tilt * phi.sin()},
           {tilt, Eigen::ArrayXd::Zero(phi.size()), -level}}};
}

}  // namespace viscoroll::detail
