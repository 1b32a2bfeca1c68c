#include "transient/contact_place.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

using Eigen::Index;

namespace {

/// Directions of the plane at the lowest point, with two corrections: tangential forces also press with their component
/// along r, and u_r moves the surface along the plane (docs/theory/friction.md, "Radial compliance").
Axes level_axes(const Eigen::ArrayXd& forward_share, const Eigen::ArrayXd& sideways_share, double sense,
                Index half_nodes) {
  const HalfField forward = as_field(forward_share, half_nodes);
  const HalfField one = HalfField::Ones(half_nodes, forward.cols());
  const HalfField none = HalfField::Zero(half_nodes, forward.cols());
  return {{{forward, sense * one, none}, {one, none, none}, {as_field(sideways_share, half_nodes), none, sense * one}}};
}

Axes axes_of_rolling(const ViscoelasticPair& pair, const SurfaceWindow& nodes) {
  const auto exact = nodes.points().axes();
  if (pair.compliance == Compliance::radial) {
    return level_axes(nodes.points().angle_ahead().values(), exact[kSideways][0].values(), -1.0, pair.half_nodes());
  }
  Axes axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t component = 0; component < 3; ++component) {
      axes[axis][component] = as_field(exact[axis][component].values(), pair.half_nodes());
    }
  }
  return axes;
}

/// Directions at the counterbody. Its frame is the mirror image of that of the rolling body, and its normals turn with
/// its curvatures.
Axes axes_of_counterbody(const ViscoelasticPair& pair, const SurfaceWindow& nodes) {
  const Curvatures& curvatures = pair.pair.on->curvatures();
  const Eigen::ArrayXd distances_ahead = nodes.grid().radius * nodes.points().angle_ahead().values();
  return level_axes(-curvatures.along * distances_ahead, -curvatures.across * nodes.z(), 1.0, pair.half_nodes());
}

/// Row below the center, not an integer.
double lowest_row(const ViscoelasticPair& pair, double shift, double angle) {
  return -angle / pair.nodes.grid.phi_spacing - shift;
}

}  // namespace

Eigen::ArrayXd at_nodes_of_rows(const Eigen::ArrayXd& rows, Index half_nodes) {
  return rows.matrix().transpose().replicate(half_nodes, 1).reshaped().array();
}

std::vector<Axes> axes_at(const ViscoelasticPair& pair, const SurfaceWindow& nodes) {
  std::vector<Axes> axes(pair.bodies.size());
  if (pair.coating().components() == 1) return axes;
  for (std::size_t b = 0; b < axes.size(); ++b) {
    axes[b] = pair.bodies[b].rolls ? axes_of_rolling(pair, nodes) : axes_of_counterbody(pair, nodes);
  }
  return axes;
}

ContactPlace place_at(const ViscoelasticPair& pair, double shift, Index half_rows, double angle, double ahead) {
  const double lowest = lowest_row(pair, shift, angle);
  const double middle = std::round(lowest);
  const auto aside = static_cast<int>(half_rows);
  SurfaceWindow nodes(pair.nodes.grid, {{-aside, aside}, {0, static_cast<int>(pair.half_nodes()) - 1}},
                      middle - lowest);
  const Index first = static_cast<Index>(middle) - half_rows;
  RowHeights heights = pair.heights.at({.first = first, .count = 2 * half_rows + 1, .shift = shift, .ahead = ahead});
  return place_of(pair, first, std::move(nodes), std::move(heights));
}

Index half_rows_in_reach(const ViscoelasticPair& pair, double shift, double angle, double ahead, double limit) {
  if (pair.heights.are_smooth()) return 0;
  const double lowest = lowest_row(pair, shift, angle);
  const double middle = std::round(lowest);
  const auto most = static_cast<int>(pair.nodes.widest.phi.last);
  // Beyond this distance, no height closes the gap. Undeformed bodies are closest in the middle of a row.
  const double distance = std::sqrt(2.0 * relative_radius(pair.pair) * std::max(limit + pair.heights.largest(), 0.0));
  const double spacing = pair.nodes.grid.radius * pair.nodes.grid.phi_spacing;
  const int aside = std::min(most, static_cast<int>(std::min(1.1 * distance / spacing, 1e9)) + 2);
  const SurfaceWindow nodes(pair.nodes.grid, {{-aside, aside}, {0, 0}}, middle - lowest);
  const Eigen::ArrayXd drop = initial_gap(nodes, {}, pair.pair);
  const RowHeights heights = pair.heights.at(
      {.first = static_cast<Index>(middle) - aside, .count = drop.size(), .shift = shift, .ahead = ahead});
  const Eigen::ArrayXd gap = drop - heights.ground - heights.tread;
  Index farthest = 0;
  for (Index row = 0; row < gap.size(); ++row) {
    if (gap[row] < limit) farthest = std::max(farthest, std::abs(row - aside));
  }
  return farthest;
}

ContactPlace place_of(const ViscoelasticPair& pair, Index first, SurfaceWindow nodes, RowHeights heights) {
  const Index count = nodes.shape().phi_nodes;
  Eigen::ArrayXd weights = half_weights(pair.half_nodes()).replicate(count, 1);
  Eigen::ArrayXd gap = initial_gap(nodes, {}, pair.pair);
  double top = 0.0;
  if (heights.ground.size() > 0) {
    const Eigen::ArrayXd height = heights.ground + heights.tread;
    gap -= at_nodes_of_rows(height, pair.half_nodes());
    top = height.maxCoeff();
  }
  Eigen::ArrayXd moment_arm = pressure_moment_arm(nodes, pair.pair);
  std::vector<Axes> axes = axes_at(pair, nodes);
  return {.first = first,
          .count = count,
          .nodes = std::move(nodes),
          .weights = std::move(weights),
          .heights = std::move(heights),
          .top = top,
          .gap = std::move(gap),
          .moment_arm = std::move(moment_arm),
          .axes = std::move(axes)};
}

}  // namespace viscoroll::detail
