#include "transient/contact_place.hpp"

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
    return level_axes(exact[kForward][0].values(), exact[kSideways][0].values(), -1.0, pair.half_nodes());
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
  return level_axes(-curvatures.along * nodes.x(), -curvatures.across * nodes.z(), 1.0, pair.half_nodes());
}

}  // namespace

std::vector<Axes> axes_at(const ViscoelasticPair& pair, const SurfaceWindow& nodes) {
  std::vector<Axes> axes(pair.bodies.size());
  if (pair.coating().components() == 1) return axes;
  for (std::size_t b = 0; b < axes.size(); ++b) {
    axes[b] = pair.bodies[b].rolls ? axes_of_rolling(pair, nodes) : axes_of_counterbody(pair, nodes);
  }
  return axes;
}

ContactPlace place_at(const ViscoelasticPair& pair, double shift, Index half_rows, double angle) {
  const double lowest = -angle / pair.nodes.grid.phi_spacing - shift;  // row below the center, not an integer
  const double middle = std::round(lowest);
  const auto aside = static_cast<int>(half_rows);
  SurfaceWindow nodes(pair.nodes.grid, {{-aside, aside}, {0, static_cast<int>(pair.half_nodes()) - 1}},
                      middle - lowest);
  return place_of(pair, static_cast<Index>(middle) - half_rows, std::move(nodes));
}

ContactPlace place_of(const ViscoelasticPair& pair, Index first, SurfaceWindow nodes) {
  const Index count = nodes.shape().phi_nodes;
  Eigen::ArrayXd weights = half_weights(pair.half_nodes()).replicate(count, 1);
  Eigen::ArrayXd gap = initial_gap(nodes, {}, pair.pair);
  Eigen::ArrayXd moment_arm = pressure_moment_arm(nodes, pair.pair);
  std::vector<Axes> axes = axes_at(pair, nodes);
  return {.first = first,
          .count = count,
          .nodes = std::move(nodes),
          .weights = std::move(weights),
          .gap = std::move(gap),
          .moment_arm = std::move(moment_arm),
          .axes = std::move(axes)};
}

}  // namespace viscoroll::detail
