#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;

ArrayXd initial_gap(const SurfaceWindow& points, double swelling, const RollingPair& pair) {
  return swelling * points.height() + pair.on.profile(points).drop;
}

ArrayXd counterpart_delay(const SurfaceWindow& points, const RollingPair& pair) {
  return pair.on.curvatures.along * pair.on.profile(points).drop;
}

ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair) {
  return relative_radius(pair) * (points.x() / points.grid().radius + pair.on.profile(points).slope);
}

ArrayXd counterpart_slope(const SurfaceWindow& points, const RollingPair& pair) {
  return -pair.on.curvatures.along * pressure_lever(points, pair);
}

}  // namespace viscoroll::detail
