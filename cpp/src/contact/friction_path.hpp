/// @file
/// @brief The path that states of stick and slip take as friction or creepage changes, docs/theory.md section 6.
///
/// Where pressure depends on friction, states at one coefficient, or one creepage, may be several, and the path from
/// little to much turns back on its way; length along it, of forces and parameter together, does not.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief A state and the parameter that it belongs to, or a difference of two.
struct PathPoint {
  VectorField force;   ///< at every node [N]
  double penetration;  ///< [m]
  double creepage;     ///< [-]
  double parameter;    ///< on a scale of relative changes
};

/// @brief Straight line in place of the path: `point`, and the change from it per unit of the parameter.
struct LinearPath {
  PathPoint point;
  PathPoint slope;
};

[[nodiscard]] inline PathPoint operator*(double factor, const PathPoint& a) {
  return {factor * a.force, factor * a.penetration, factor * a.creepage, factor * a.parameter};
}

[[nodiscard]] inline PathPoint operator+(const PathPoint& a, const PathPoint& b) {
  return {a.force + b.force, a.penetration + b.penetration, a.creepage + b.creepage, a.parameter + b.parameter};
}

[[nodiscard]] inline PathPoint operator-(const PathPoint& a, const PathPoint& b) { return a + -1.0 * b; }

/// @brief Lengths on the path: forces relative to those of a state, and the parameter.
class PathMetric {
 public:
  explicit PathMetric(const VectorField& force) : scale_(1.0 / force.square().sum()) {}

  [[nodiscard]] double dot(const PathPoint& a, const PathPoint& b) const {
    return scale_ * (a.force * b.force).sum() + a.parameter * b.parameter;
  }
  [[nodiscard]] PathPoint unit(const PathPoint& a) const { return 1.0 / std::sqrt(dot(a, a)) * a; }

 private:
  double scale_;
};

}  // namespace viscoroll::detail
