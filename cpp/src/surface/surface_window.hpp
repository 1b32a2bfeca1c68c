/// @file
/// @brief The nodes of the candidate contact surface and their directions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <memory>
#include <optional>
#include <vector>

#include "surface/window.hpp"

namespace viscoroll::detail {

/// @brief A sphere, or the tread of a wheel, with its grid of nodes at equal spacings in phi and theta, one of them at
/// the lowest point phi = theta = pi/2.
struct SurfaceGrid {
  double radius;         ///< r_o [m]
  double phi_spacing;    ///< [rad]
  double theta_spacing;  ///< [rad]
  /// Whether nodes keep their distances, r_o times the spacings, along a plane, and the sphere's height above it is
  /// that of its paraboloid: over a plane that deforms, whose nodes they are, too (docs/theory/planes-and-pairs.md).
  bool is_paraboloid = false;
  /// Of a wheel, whose nodes lie at equal distances, r_o times the spacing, along its axis [m]; infinite: flat. None of
  /// a sphere.
  std::optional<double> crown_radius = std::nullopt;

  /// @return radius of the surface across [m]
  [[nodiscard]] double radius_across() const { return crown_radius.value_or(radius); }
};

/// @brief Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
/// @return how many nodes of a revolution lie up to there, to either side of the lowest one
[[nodiscard]] constexpr auto nodes_to_60_degrees(std::integral auto nodes_per_revolution) {
  return nodes_per_revolution / 6;
}

/// @brief Numbers at the nodes of a window that rows and columns tell: the sum of a product of both and of one of the
/// column's own. On large windows the numbers themselves would be most of what memory holds.
struct WindowField {
  Eigen::ArrayXd rows;
  Eigen::ArrayXd columns;
  Eigen::ArrayXd added;  ///< none where nothing is added

  [[nodiscard]] double operator()(Eigen::Index row, Eigen::Index column) const {
    const double product = rows[row] * columns[column];
    return added.size() == 0 ? product : product + added[column];
  }
  /// @return the number at some nodes
  [[nodiscard]] Eigen::ArrayXd at(const std::vector<Eigen::Index>& nodes) const {
    return Eigen::ArrayXd::NullaryExpr(static_cast<Eigen::Index>(nodes.size()), [&](Eigen::Index i) {
      const Eigen::Index node = nodes[static_cast<std::size_t>(i)];
      return (*this)(node / columns.size(), node % columns.size());
    });
  }
  /// @return the number at every node
  [[nodiscard]] Eigen::ArrayXd values() const {
    return Eigen::ArrayXd::NullaryExpr(rows.size() * columns.size(), [&](Eigen::Index node) {
      return (*this)(node / columns.size(), node % columns.size());
    });
  }
};

/// @brief Points of a rectangle of the grid, as rows and columns tell them.
struct SurfacePoints {
  SurfaceGrid grid;
  Window window;       ///< less than a quarter revolution from the lowest point
  double shift = 0.0;  ///< of all points downstream of the nodes [spacings]

  /// @return undeformed positions forward and sideways [m]
  [[nodiscard]] WindowField x() const;
  [[nodiscard]] WindowField z() const;
  /// @return undeformed positions downward [m]
  [[nodiscard]] WindowField y() const;

  /// @return directions x (forward), y (down) and z (sideways), each by its components (r, phi, theta) at every point:
  /// the rows of the rotation Q of paper equation (40), where U = -x, V = -z and W = y; on a wheel theta is along the
  /// profile
  [[nodiscard]] std::array<std::array<WindowField, 3>, 3> axes() const;
};

/// @brief The nodes of a rectangle of the grid. Copies share their positions.
class SurfaceWindow {
 public:
  /// @param[in] grid all nodes
  /// @param[in] window its nodes, less than a quarter revolution from the lowest point
  /// @param[in] shift of all points downstream of the nodes [spacings]
  SurfaceWindow(const SurfaceGrid& grid, const Window& window, double shift = 0.0);

  [[nodiscard]] WindowShape shape() const { return window_.shape(); }
  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] const Window& window() const { return window_; }
  /// @return how far downstream of the nodes the points are [spacings]
  [[nodiscard]] double shift() const { return shift_; }

  /// Undeformed positions [m]: x forward, z sideways.
  [[nodiscard]] const Eigen::ArrayXd& x() const { return positions_->x; }
  [[nodiscard]] const Eigen::ArrayXd& z() const { return positions_->z; }
  /// @return height of every undeformed node above the lowest point, r_o - y without its round-off [m]
  [[nodiscard]] const Eigen::ArrayXd& height() const { return positions_->height; }
  /// @return way by which every point falls behind the lowest one as it comes from its upstream neighbor, for what lies
  /// at height h above that moves at Omega (r_o - h): the integral of h dphi [m]; 0 in the first row
  [[nodiscard]] Eigen::ArrayXd lag() const;
  /// @return x of the undeformed points as turning alone changes it: on a paraboloid, which lies at height h above the
  /// lowest point and moves at Omega (r_o - h), the integral of that [m]
  [[nodiscard]] Eigen::ArrayXd rolled() const;
  /// @return area of the patch of each of some nodes [m^2]
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
