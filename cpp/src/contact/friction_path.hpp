/// @file
/// @brief The path that states of stick and slip take as friction changes, docs/theory.md section 6.
///
/// Where pressure depends on friction, states at one coefficient may be several, and the path from little friction to
/// much turns back on its way; length along it, of forces and friction together, does not.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief A state and its friction, or a difference of two.
struct PathPoint {
  VectorField force;    ///< at every node [N]
  double penetration;   ///< [m]
  double creepage;      ///< [-]
  double log_friction;  ///< logarithm of mu
};

/// @brief Straight line in place of the path: `point`, and the change from it per logarithm of friction.
struct LinearPath {
  PathPoint point;
  PathPoint slope;
};

[[nodiscard]] inline PathPoint operator*(double factor, const PathPoint& a) {
  return {factor * a.force, factor * a.penetration, factor * a.creepage, factor * a.log_friction};
}

[[nodiscard]] inline PathPoint operator+(const PathPoint& a, const PathPoint& b) {
  return {a.force + b.force, a.penetration + b.penetration, a.creepage + b.creepage, a.log_friction + b.log_friction};
}

[[nodiscard]] inline PathPoint operator-(const PathPoint& a, const PathPoint& b) { return a + -1.0 * b; }

/// @brief Lengths on the path: forces relative to those of a state, and the logarithm of friction.
class PathMetric {
 public:
  explicit PathMetric(const VectorField& force) : scale_(1.0 / force.square().sum()) {}

  [[nodiscard]] double dot(const PathPoint& a, const PathPoint& b) const {
    return scale_ * (a.force * b.force).sum() + a.log_friction * b.log_friction;
  }
  [[nodiscard]] PathPoint unit(const PathPoint& a) const { return 1.0 / std::sqrt(dot(a, a)) * a; }

 private:
  double scale_;
};

}  // namespace viscoroll::detail
