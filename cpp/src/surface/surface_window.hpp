/// @file
/// @brief Window of nodes of the candidate contact surface, their positions and directions, and the curvatures of a
/// surface at the contact.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <concepts>
#include <memory>
#include <optional>
#include <vector>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Consecutive nodes in one direction, counted from the lowest point.
struct NodeRange {
  int first;
  int last;  ///< last node, inclusive

  [[nodiscard]] int count() const { return last - first + 1; }
  /// @return range of every other node whose fine neighbors on both sides are in this range
  [[nodiscard]] NodeRange coarsened() const { return {-((-first - 1) / 2), (last - 1) / 2}; }
  friend bool operator==(const NodeRange&, const NodeRange&) = default;
};

/// @brief Rectangle of nodes, numbered row by row. Material crosses it from row to row; upstream rows come first.
struct Window {
  NodeRange phi;
  NodeRange theta;

  [[nodiscard]] WindowShape shape() const { return {phi.count(), theta.count()}; }
  /// @return whether it is a single row of nodes along the path: line contact, which has no edges sideways
  [[nodiscard]] bool is_line() const { return theta.first == 0 && theta.last == 0; }
  /// @return number of node (i, k) in this window
  [[nodiscard]] Eigen::Index number_of(int i, int k) const {
    return static_cast<Eigen::Index>(i - phi.first) * theta.count() + k - theta.first;
  }
  /// @return number in this window of the node with number `node` in another window inside this one
  [[nodiscard]] Eigen::Index number_of(const Window& other, Eigen::Index node) const {
    return number_of(other.phi.first + static_cast<int>(node / other.theta.count()),
                     other.theta.first + static_cast<int>(node % other.theta.count()));
  }
  /// @return window of every other node
  [[nodiscard]] Window coarsened() const { return {phi.coarsened(), theta.coarsened()}; }
  friend bool operator==(const Window&, const Window&) = default;
};

/// @brief Call function(node, number in `outer`) for every node of a window inside another one.
template <class Function>
void for_nodes_within(const Window& outer, const Window& inner, const Function& function) {
  Eigen::Index node = 0;
  for (int i = inner.phi.first; i <= inner.phi.last; ++i) {
    for (int k = inner.theta.first; k <= inner.theta.last; ++k) function(node++, outer.number_of(i, k));
  }
}

/// @brief Curvatures of a surface [1/m], positive if the surface is convex, negative if it is concave.
struct Curvatures {
  double along = 0.0;   ///< along the path
  double across = 0.0;  ///< across the path

  friend bool operator==(const Curvatures&, const Curvatures&) = default;
};

/// @brief Sphere or tread of a wheel with a grid of nodes at equal spacings in phi and theta. One node lies at the
/// lowest point, phi = theta = pi/2.
struct SurfaceGrid {
  double radius;         ///< r_o [m]
  double phi_spacing;    ///< [rad]
  double theta_spacing;  ///< [rad]
  /// Whether the nodes lie on a plane, at distances of r_o times the spacings, below the paraboloid of the sphere. This
  /// is so if the counterbody deforms, whose nodes they are as well (docs/theory/planes-and-pairs.md).
  bool is_paraboloid = false;
  /// Radius of the crown of a wheel [m], infinite if the tread is flat; empty for a sphere. The nodes of a wheel lie
  /// along its axis at equal distances, r_o times the spacing.
  std::optional<double> crown_radius = std::nullopt;

  /// @return radius of curvature across the path [m]
  [[nodiscard]] double radius_across() const { return crown_radius.value_or(radius); }
};

/// @brief Number of nodes within 60 degrees of the lowest one, on either side.
/// Beyond this angle the plane is closer to parallel than to normal to the surface, and nodes cannot support a load.
[[nodiscard]] constexpr auto nodes_to_60_degrees(std::integral auto nodes_per_revolution) {
  return nodes_per_revolution / 6;
}

/// @brief Field on the nodes of a window that is a function of row and column: the product of a row factor and a column
/// factor, plus a term of the column. On large windows all node values together would take most of the memory.
struct WindowField {
  Eigen::ArrayXd rows;
  Eigen::ArrayXd columns;
  Eigen::ArrayXd added;  ///< empty if the sum has no such term

  [[nodiscard]] double operator()(Eigen::Index row, Eigen::Index column) const {
    const double product = rows[row] * columns[column];
    return added.size() == 0 ? product : product + added[column];
  }
  /// @return values at the given nodes
  [[nodiscard]] Eigen::ArrayXd at(const std::vector<Eigen::Index>& nodes) const {
    return Eigen::ArrayXd::NullaryExpr(static_cast<Eigen::Index>(nodes.size()), [&](Eigen::Index i) {
      const Eigen::Index node = nodes[static_cast<std::size_t>(i)];
      return (*this)(node / columns.size(), node % columns.size());
    });
  }
  /// @return values at every node
  [[nodiscard]] Eigen::ArrayXd values() const {
    return Eigen::ArrayXd::NullaryExpr(rows.size() * columns.size(), [&](Eigen::Index node) {
      return (*this)(node / columns.size(), node % columns.size());
    });
  }
};

/// @brief Points of a rectangle of the grid, as fields of rows and columns.
struct SurfacePoints {
  SurfaceGrid grid;
  Window window;       ///< within a quarter revolution of the lowest point
  double shift = 0.0;  ///< distance of all points downstream of the nodes [spacings]

  /// @return undeformed position along x (forward) and z (sideways) [m]
  [[nodiscard]] WindowField x() const;
  [[nodiscard]] WindowField z() const;
  /// @return undeformed position along y (down) [m]
  [[nodiscard]] WindowField y() const;
  /// @return angle ahead of the lowest point, about the axis of rolling [rad]
  [[nodiscard]] WindowField angle_ahead() const;

  /// @return directions x (forward), y (down) and z (sideways), each as its components (r, phi, theta) at every point.
  /// These are the rows of the rotation Q of the paper's equation (40), with U = -x, V = -z and W = y. On a wheel,
  /// theta is along the profile.
  [[nodiscard]] std::array<std::array<WindowField, 3>, 3> axes() const;
};

/// @brief Nodes of a rectangle of the grid. Copies share their positions.
class SurfaceWindow {
 public:
  /// @param[in] grid all nodes of the body
  /// @param[in] window nodes of the rectangle, within a quarter revolution of the lowest point
  /// @param[in] shift distance of all points downstream of the nodes [spacings]
  SurfaceWindow(const SurfaceGrid& grid, const Window& window, double shift = 0.0);

  [[nodiscard]] WindowShape shape() const { return window_.shape(); }
  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] const Window& window() const { return window_; }
  /// @return distance of the points downstream of the nodes [spacings]
  [[nodiscard]] double shift() const { return shift_; }

  /// Undeformed positions [m]: x forward, z sideways.
  [[nodiscard]] const Eigen::ArrayXd& x() const { return positions_->x; }
  [[nodiscard]] const Eigen::ArrayXd& z() const { return positions_->z; }
  /// @return height of every undeformed node above the lowest point [m]: r_o - y, without its round-off
  [[nodiscard]] const Eigen::ArrayXd& height() const { return positions_->height; }
  /// @return distance by which each point lags behind the lowest one over the step from its upstream neighbor [m], if
  /// material at height h above the lowest point moves at Omega (r_o - h): the integral of h dphi; 0 in the first row
  [[nodiscard]] Eigen::ArrayXd lag() const;
  /// @return x of the undeformed points as rotation alone changes it [m]. On a paraboloid, points at height h above the
  /// lowest one move at Omega (r_o - h), and x is the integral of this.
  [[nodiscard]] Eigen::ArrayXd rolled() const;
  /// @return patch areas of the given nodes [m^2]
  [[nodiscard]] Eigen::ArrayXd patch_area(const std::vector<Eigen::Index>& nodes) const;
  /// @return phi of every node [rad]
  [[nodiscard]] Eigen::ArrayXd phi() const;
  /// @return theta of every node of a sphere [rad]
  [[nodiscard]] Eigen::ArrayXd theta() const;

  [[nodiscard]] SurfacePoints points() const { return {grid_, window_, shift_}; }

 private:
  struct Positions {
    Eigen::ArrayXd x, z, height;
  };
  [[nodiscard]] Positions on_sphere() const;
  [[nodiscard]] Positions on_paraboloid() const;

  SurfaceGrid grid_;
  Window window_;
  double shift_;
  std::shared_ptr<const Positions> positions_;
};

}  // namespace viscoroll::detail
