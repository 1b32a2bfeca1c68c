#include "surface/surface_window.hpp"

#include <cmath>
#include <numbers>
#include <vector>

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

}  // namespace

SurfaceWindow::SurfaceWindow(const SurfaceGrid& grid, const Window& window, double shift)
    : grid_(grid), window_(window), shift_(shift) {
  const auto& [phi, theta] = window;
  const Eigen::Index count = shape().size();
  x_.resize(count);
  y_.resize(count);
  z_.resize(count);
  height_.resize(count);
  // Sines of the offsets from pi/2 keep the mirror symmetry to the last bit.
  std::vector<Angle> columns;
  for (int k = theta.first; k <= theta.last; ++k) columns.emplace_back(-k * grid.theta_spacing);  // pi/2 - theta
  Eigen::Index node = 0;
  for (int i = phi.first; i <= phi.last; ++i) {
    const Angle forward(-(i + shift) * grid.phi_spacing);  // pi/2 - phi
    for (const Angle& sideways : columns) {
      x_[node] = grid.radius * sideways.cosine * forward.sine;
      y_[node] = grid.radius * sideways.cosine * forward.cosine;
      z_[node] = grid.radius * sideways.sine;
      height_[node] = grid.radius * (sideways.versine + sideways.cosine * forward.versine);
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
    const double theta = static_cast<double>(window_.theta.first + node % columns) * grid_.theta_spacing;
    const Angle forward(middle);
    const Angle sideways(theta);
    lag[node] = grid_.is_paraboloid
                    ? 0.5 * step * (std::pow(middle, 2) + std::pow(theta, 2) + std::pow(step, 2) / 12.0)
                    : step * sideways.versine + sideways.cosine * (step - chord + chord * forward.versine);
  }
  return grid_.radius * lag;
}

Eigen::ArrayXd SurfaceWindow::patch_area() const {
  const double equatorial = std::pow(grid_.radius, 2) * grid_.phi_spacing * grid_.theta_spacing;
  if (grid_.is_paraboloid) return Eigen::ArrayXd::Constant(shape().size(), equatorial);
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
  const double r = grid_.radius;
  const Eigen::ArrayXd phi = this->phi();
  return {{{x_ / r, -phi.sin(), z_ / r * phi.cos()},
           {y_ / r, phi.cos(), z_ / r * phi.sin()},
           {z_ / r, Eigen::ArrayXd::Zero(phi.size()), -theta().sin()}}};
}

}  // namespace viscoroll::detail
