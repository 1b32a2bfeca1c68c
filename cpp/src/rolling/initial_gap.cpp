#include "rolling/initial_gap.hpp"

#include <cmath>

namespace viscoroll::detail {

using Eigen::ArrayXd;
using Eigen::Index;

namespace {

auto all_of(const SurfaceWindow& points) { return Eigen::seqN(Index{0}, points.shape().size()); }

/// @param[in] nodes numbers of some or all of them
template <class Nodes>
ArrayXd lever_at(const SurfaceWindow& points, const RollingPair& pair, const Nodes& nodes) {
  ArrayXd slope = points.x()(nodes) / points.grid().radius;
  const ArrayXd tilt = pair.on->profile(points).slope;
  if (tilt.size() > 0) slope += tilt(nodes);
  return relative_radius(pair) * slope;
}

template <class Nodes>
ArrayXd slope_at(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair,
                 const Nodes& nodes) {
  return -growth.met() * pair.on->curvatures().along * lever_at(points, pair, nodes);
}

/// Gap for centrifugal growth in all directions.
ArrayXd swollen_gap(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  ArrayXd gap = growth.own * points.height();
  const ArrayXd drop = pair.on->profile(points).drop;
  if (drop.size() > 0) gap += growth.met() * drop;
  return gap;
}

}  // namespace

ArrayXd initial_gap(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  ArrayXd gap = swollen_gap(points, growth, pair);
  if (growth == CentrifugalGrowth{} || !std::isfinite(width(pair))) return gap;
  // A tread does not grow along its axis, so that its crown does not change.
  const SurfaceWindow across(points.grid(), {{0, 0}, points.window().theta});
  const ArrayXd grown = swollen_gap(across, growth, pair) - swollen_gap(across, {}, pair);
  gap -= grown.replicate(points.shape().phi_nodes, 1);
  return gap;
}

ArrayXd counterbody_delay(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  const ArrayXd drop = pair.on->profile(points).drop;
  if (drop.size() == 0) return ArrayXd::Zero(points.shape().size());
  return growth.met() * pair.on->curvatures().along * drop;
}

ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair) {
  return lever_at(points, pair, all_of(points));
}

ArrayXd pressure_lever(const SurfaceWindow& points, const RollingPair& pair, const std::vector<Index>& nodes) {
  return lever_at(points, pair, nodes);
}

ArrayXd counterbody_slope(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  return slope_at(points, growth, pair, all_of(points));
}

ArrayXd counterbody_slope(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair,
                          const std::vector<Index>& nodes) {
  return slope_at(points, growth, pair, nodes);
}

}  // namespace viscoroll::detail
