#include "rolling/initial_gap.hpp"

#include <cmath>

namespace viscoroll::detail {

using Eigen::ArrayXd;
using Eigen::Index;

namespace {

auto all_of(const SurfaceWindow& points) { return Eigen::seqN(Index{0}, points.shape().size()); }

/// @param[in] points nodes of the rolling body
/// @param[in] pair both bodies
/// @param[in] nodes numbers of the nodes to evaluate
template <class Nodes>
ArrayXd moment_arm_at(const SurfaceWindow& points, const RollingPair& pair, const Nodes& nodes) {
  ArrayXd slope = points.x()(nodes) / points.grid().radius;
  const ArrayXd counterbody_slopes = pair.on->profile(points).slope;
  if (counterbody_slopes.size() > 0) slope += counterbody_slopes(nodes);
  return relative_radius(pair) * slope;
}

template <class Nodes>
ArrayXd slope_at(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair,
                 const Nodes& nodes) {
  return -growth.met() * pair.on->curvatures().along * moment_arm_at(points, pair, nodes);
}

/// Gap if both bodies grow by the same fraction in all directions.
ArrayXd uniformly_grown_gap(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  ArrayXd gap = growth.own * points.height();
  const ArrayXd drop = pair.on->profile(points).drop;
  if (drop.size() > 0) gap += growth.met() * drop;
  return gap;
}

}  // namespace

ArrayXd initial_gap(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  ArrayXd gap = uniformly_grown_gap(points, growth, pair);
  if (growth == CentrifugalGrowth{} || !std::isfinite(width(pair))) return gap;
  // A tread does not grow along its axis, so that its crown does not change.
  const SurfaceWindow across(points.grid(), {{0, 0}, points.window().theta});
  const ArrayXd grown = uniformly_grown_gap(across, growth, pair) - uniformly_grown_gap(across, {}, pair);
  gap -= grown.replicate(points.shape().phi_nodes, 1);
  return gap;
}

ArrayXd counterbody_delay(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  const ArrayXd drop = pair.on->profile(points).drop;
  if (drop.size() == 0) return ArrayXd::Zero(points.shape().size());
  return growth.met() * pair.on->curvatures().along * drop;
}

ArrayXd pressure_moment_arm(const SurfaceWindow& points, const RollingPair& pair) {
  return moment_arm_at(points, pair, all_of(points));
}

ArrayXd pressure_moment_arm(const SurfaceWindow& points, const RollingPair& pair, const std::vector<Index>& nodes) {
  return moment_arm_at(points, pair, nodes);
}

ArrayXd counterbody_slope(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair) {
  return slope_at(points, growth, pair, all_of(points));
}

ArrayXd counterbody_slope(const SurfaceWindow& points, const CentrifugalGrowth& growth, const RollingPair& pair,
                          const std::vector<Index>& nodes) {
  return slope_at(points, growth, pair, nodes);
}

}  // namespace viscoroll::detail
