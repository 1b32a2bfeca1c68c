#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;

namespace {

/// Of a profile, which has no numbers where it is flat.
void add(const ArrayXd& numbers, ArrayXd& sum) {
  if (numbers.size() > 0) sum += numbers;
}

}  // namespace

ArrayXd initial_gap(const SurfaceWindow& points, double swelling, const RollingPair& pair) {
  ArrayXd gap = swelling * points.height();
  add(pair.on.profile(points).drop, gap);
  return gap;
}

ArrayXd counterpart_delay(const SurfaceWindow& points, const RollingPair& pair) {
  ArrayXd drop = ArrayXd::Zero(points.shape().size());
  add(pair.on.profile(points).drop, drop);
  return pair.on.curvatures.along * drop;
}

ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair) {
  ArrayXd slope = points.x() / points.grid().radius;
  add(pair.on.profile(points).slope, slope);
  return relative_radius(pair) * slope;
}

ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair, const std::vector<Eigen::Index>& nodes) {
  ArrayXd slope = points.x()(nodes) / points.grid().radius;
  const ArrayXd tilt = pair.on.profile(points).slope;
  if (tilt.size() > 0) slope += tilt(nodes);
  return relative_radius(pair) * slope;
}

ArrayXd counterpart_slope(const SurfaceWindow& points, const RollingPair& pair) {
  return -pair.on.curvatures.along * pressure_lever(points, pair);
}

ArrayXd counterpart_slope(const SurfaceWindow& points, const RollingPair& pair,
                          const std::vector<Eigen::Index>& nodes) {
  return -pair.on.curvatures.along * pressure_lever(points, pair, nodes);
}

}  // namespace viscoroll::detail
