/// @file
/// @brief How the surface of a layered body runs, and with it every surface at a depth.
#pragma once

#include <cmath>
#include <numbers>

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief How a surface runs in one of its two directions.
enum class Way {
  ring,     ///< around the center: orders are per radian
  line,     ///< straight on: orders are per radius of the metric
  nothing,  ///< straight on, and nothing varies: forces and powers are per length
};

/// @brief Below this k^2 a torus has orders that no sphere has: those of a sphere start at L = 2, its rigid motions.
constexpr double kLowOrders = 4.0;

/// @brief What makes orders wave numbers, and angles lengths. Places along the normal are radii where a way is a ring,
/// else heights above the surface.
struct Metric {
  double radius;                            ///< r [m]: order k has the wave number k / r at the surface
  Way along = Way::ring;                    ///< the direction in which material crosses the contact, phi
  Way across = Way::ring;                   ///< theta
  Curvature curvature = Curvature::sphere;  ///< how much of it the equations keep where both are rings

  [[nodiscard]] constexpr bool is_curved() const { return along == Way::ring; }
  [[nodiscard]] constexpr bool is_sphere() const { return is_curved() && across == Way::ring; }
  [[nodiscard]] constexpr bool is_wheel() const { return is_curved() && across == Way::line; }
  /// @return 1 where the surface bends towards the center that way, else 0
  static constexpr double bend(Way way) { return way == Way::ring ? 1.0 : 0.0; }
  /// @return in both ways together: times u_r / r the change of area by a displacement outwards
  [[nodiscard]] constexpr double bends() const { return bend(along) + bend(across); }

  /// @return the place of the surface
  [[nodiscard]] constexpr double surface() const { return is_curved() ? radius : 0.0; }

  /// @return e-folds of an order 1 between two places
  [[nodiscard]] double depth(double outer, double inner) const {
    return is_curved() ? std::log1p((outer - inner) / inner) : (outer - inner) / radius;
  }
  /// @return the place that lies so many e-folds of an order 1 deeper
  [[nodiscard]] double below(double place, double depth) const {
    return is_curved() ? place * std::exp(-depth) : place - depth * radius;
  }

  /// @return an order across as it is at a place, per what it is at the surface: on a wheel it keeps its wave number,
  /// and shrinks with the radius about the order along
  [[nodiscard]] constexpr double shrinkage(double place) const { return is_wheel() ? place / radius : 1.0; }

  /// @return length of a radian in one direction at a place [m]; 1 where nothing varies
  [[nodiscard]] constexpr double length(Way way, double place) const {
    return way == Way::ring ? place : way == Way::line ? radius : 1.0;
  }
  /// @return that of a radian along [m]: orders per length are wave numbers, stresses times length are those of states
  [[nodiscard]] constexpr double length(double place) const { return length(along, place); }
  /// @return area of a radian by a radian at a place, so that measure times dr dphi dtheta is volume
  [[nodiscard]] constexpr double measure(double place) const { return length(along, place) * length(across, place); }

  /// @return area of the surface over which what one wave of each order does adds up [m^2], or [m] where nothing varies
  [[nodiscard]] constexpr double area_of_waves() const {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    return measure(surface()) * kTurn * (across == Way::nothing ? 1.0 : kTurn);
  }

  /// @return exponent by which the slowest solution of an order dies out with depth. Around a cylinder displacements
  /// turn with the material: order 1 is a translation.
  [[nodiscard]] constexpr double fall(double k) const { return is_curved() && !is_sphere() ? k - 1.0 : k; }

  /// @brief What the surface of a sphere adds to the stiffness against tangential displacements, per mu: L - 2 on a
  /// sphere, where L = 2 are rigid motions; k^2 in the paper's equation (26), and where it is straight across.
  /// See docs/theory/layers.md.
  /// @param[in] k2 k^2 = m^2 + n^2; L = l (l + 1) of the exact sphere
  [[nodiscard]] constexpr double membrane_stiffness(double k2) const {
    if (!is_sphere() || curvature == Curvature::paper) return k2;
    return curvature == Curvature::sphere && k2 < kLowOrders ? 0.5 * k2 : k2 - 2.0;
  }
};

}  // namespace viscoroll::detail
