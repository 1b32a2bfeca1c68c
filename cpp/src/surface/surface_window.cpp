#include "surface/surface_window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "modal/layered_body.hpp"

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

/// Circle about the axis of rolling on which the nodes at one distance from the middle lie.
struct Circle {
  double z;       ///< position sideways [m]
  double radius;  ///< [m]
  double drop;    ///< largest radius minus this radius [m]
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

/// Angle of every row from the lowest point, positive forward [rad].
Eigen::ArrayXd row_angles(const SurfacePoints& points) {
  return Eigen::ArrayXd::NullaryExpr(points.window.phi.count(), [&](Eigen::Index row) {
    return -(static_cast<double>(points.window.phi.first + row) + points.shift) * points.grid.phi_spacing;
  });
}

template <class Function>
Eigen::ArrayXd over_columns(const Window& window, const Function& function) {
  return Eigen::ArrayXd::NullaryExpr(window.theta.count(), [&](Eigen::Index column) {
    return function(window.theta.first + static_cast<int>(column));
  });
}

}  // namespace

SurfaceWindow::SurfaceWindow(const SurfaceGrid& grid, const Window& window, double shift)
    : grid_(grid),
      window_(window),
      shift_(shift),
      positions_(std::make_shared<const Positions>(grid.is_paraboloid ? on_paraboloid() : on_sphere())) {}

SurfaceWindow::Positions SurfaceWindow::on_sphere() const {
  const auto& [phi, theta] = window_;
  const Eigen::Index count = shape().size();
  Positions nodes{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
  std::vector<Circle> circles;
  for (int k = theta.first; k <= theta.last; ++k) circles.push_back(circle_at(grid_, k));
  Eigen::Index node = 0;
  for (int i = phi.first; i <= phi.last; ++i) {
    const Angle forward(-(i + shift_) * grid_.phi_spacing);  // pi/2 - phi
    for (const Circle& circle : circles) {
      nodes.x[node] = circle.radius * forward.sine;
      nodes.z[node] = circle.z;
      nodes.height[node] = circle.drop + circle.radius * forward.versine;
      ++node;
    }
  }
  return nodes;
}

SurfaceWindow::Positions SurfaceWindow::on_paraboloid() const {
  const double r = grid_.radius;
  Positions nodes{.x = points().x().values(), .z = points().z().values(), .height = {}};
  nodes.height = (nodes.x.square() + nodes.z.square()) / (2.0 * r);
  return nodes;
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
  if (!grid_.is_paraboloid) return x();
  return x() * (1.0 - (x().square() / 3.0 + z().square()) / (2.0 * std::pow(grid_.radius, 2)));
}

Eigen::ArrayXd SurfaceWindow::patch_area(const std::vector<Eigen::Index>& nodes) const {
  const double equatorial = std::pow(grid_.radius, 2) * grid_.phi_spacing * grid_.theta_spacing;
  const bool is_level = grid_.is_paraboloid || grid_.crown_radius;
  const Eigen::ArrayXd areas = over_columns(
      window_, [&](int column) { return is_level ? equatorial : equatorial * std::cos(column * grid_.theta_spacing); });
  Eigen::ArrayXd picked(static_cast<Eigen::Index>(nodes.size()));
  std::ranges::transform(nodes, picked.begin(), [&](Eigen::Index node) { return areas[node % areas.size()]; });
  return picked;
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

WindowField SurfacePoints::x() const {
  const Eigen::ArrayXd forward = row_angles(*this);
  if (grid.is_paraboloid) return {grid.radius * forward, Eigen::ArrayXd::Ones(window.theta.count()), {}};
  return {forward.sin(), over_columns(window, [&](int column) { return circle_at(grid, column).radius; }), {}};
}

WindowField SurfacePoints::y() const {
  const Eigen::ArrayXd forward = row_angles(*this);
  if (grid.is_paraboloid) {
    return {grid.radius * (1.0 - 0.5 * forward.square()), Eigen::ArrayXd::Ones(window.theta.count()),
            z().columns.square() / (-2.0 * grid.radius)};
  }
  return {forward.cos(), over_columns(window, [&](int column) { return circle_at(grid, column).radius; }), {}};
}

WindowField SurfacePoints::z() const {
  return {Eigen::ArrayXd::Ones(window.phi.count()),
          over_columns(window,
                       [&](int column) {
                         return grid.is_paraboloid ? -grid.radius * grid.theta_spacing * column
                                                   : circle_at(grid, column).z;
                       }),
          {}};
}

WindowField SurfacePoints::angle_ahead() const {
  return {row_angles(*this), Eigen::ArrayXd::Ones(window.theta.count()), {}};
}

std::array<std::array<WindowField, 3>, 3> SurfacePoints::axes() const {
  const Eigen::ArrayXd forward = row_angles(*this);
  const Eigen::ArrayXd sine = forward.sin();
  const Eigen::ArrayXd cosine = forward.cos();
  const Eigen::ArrayXd tilt = z().columns / grid.radius_across();  // component of the normal along z
  // The other component is sin(theta), by which the circles of a sphere are smaller as well.
  const Eigen::ArrayXd level = over_columns(window, [&](int column) { return std::cos(column * grid.theta_spacing); });
  const Eigen::ArrayXd columns = Eigen::ArrayXd::Ones(tilt.size());
  const Eigen::ArrayXd rows = Eigen::ArrayXd::Ones(forward.size());
  WindowField forward_share{sine, level, {}};
  WindowField down_share{cosine, level, {}};
  WindowField sideways_share{rows, level, {}};
  if (grid.crown_radius) {
    for (WindowField* share : {&forward_share, &down_share, &sideways_share}) {
      share->columns = (1.0 - tilt.square()).sqrt();
    }
  } else if (grid.is_paraboloid) {
    forward_share = {forward, columns, {}};
    down_share = {1.0 - 0.5 * forward.square(), columns, -0.5 * tilt.square()};
  }
  sideways_share.rows *= -1.0;
  return {{{forward_share, WindowField{-cosine, columns, {}}, WindowField{sine, tilt, {}}},
           {down_share, WindowField{sine, columns, {}}, WindowField{cosine, tilt, {}}},
           {WindowField{rows, tilt, {}}, WindowField{0.0 * rows, columns, {}}, sideways_share}}};
}

}  // namespace viscoroll::detail
