#include "rolling/initial_gap.hpp"

#include <cmath>
#include <numbers>

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;

/// From the summit of a roller at the same arcs, forward [rad].
ArrayXd counterpart_angle(const SurfaceWindow& points, double radius) {
  return (std::numbers::pi / 2.0 - points.phi()) * (points.grid().radius / radius);
}

/// Of a circle above its lowest point, 1/k - sqrt(1/k^2 - x^2), without the round-off of small curvatures.
ArrayXd rise_of_circle(const ArrayXd& x, double curvature) {
  return curvature * x.square() / (1.0 + (1.0 - (curvature * x).square()).max(0.0).sqrt());
}

}  // namespace

ArrayXd counterpart_drop(const SurfaceWindow& points, const Counterpart& on) {
  if (std::holds_alternative<CoatedCylinder>(on)) {
    const double radius = radius_of(on);
    return 2.0 * radius * (0.5 * counterpart_angle(points, radius)).sin().square();
  }
  const TrackCurvature track = track_curvature(on);
  if (track.along == 0.0 && track.across == 0.0) return ArrayXd::Zero(points.shape().size());
  if (points.grid().is_paraboloid) {
    return -0.5 * (track.along * points.x().square() + track.across * points.z().square());
  }
  return -rise_of_circle(points.x(), track.along) - rise_of_circle(points.z(), track.across);
}

ArrayXd counterpart_delay(const SurfaceWindow& points, const RollingPair& pair) {
  return counterpart_curvature(pair) * counterpart_drop(points, pair.on);
}

ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair) {
  if (!std::holds_alternative<CoatedCylinder>(pair.on)) return points.x();
  const double radius = radius_of(pair.on);
  return relative_radius(pair) * (points.x() / points.grid().radius + counterpart_angle(points, radius).sin());
}

}  // namespace viscoroll::detail
