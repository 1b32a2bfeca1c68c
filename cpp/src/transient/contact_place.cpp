#include "transient/contact_place.hpp"

#include <cmath>
#include <utility>

#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

using Eigen::Index;

Axes axes_at(const CreepingPair& pair, const SurfaceWindow& nodes) {
  const Index half_nodes = pair.half_nodes();
  Axes axes;
  if (pair.bodies.front().tables.components() == 1) return axes;
  const auto exact = nodes.axes();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t component = 0; component < 3; ++component) {
      axes[axis][component] = as_field(exact[axis][component], half_nodes);
    }
  }
  if (pair.compliance == Compliance::vertical) return axes;
  // As at the lowest point, but that forces along the plane press with their share of r, and u_r moves the surface
  // along the plane: theory.md section 6.
  const HalfField one = HalfField::Ones(half_nodes, axes[0][0].cols());
  const HalfField none = HalfField::Zero(half_nodes, axes[0][0].cols());
  return {{{axes[0][0], -one, none}, {one, none, none}, {axes[2][0], none, -one}}};
}

ContactPlace place_at(const CreepingPair& pair, double shift, Index half_rows, double angle) {
  const double lowest = -angle / pair.nodes.grid.phi_spacing - shift;  // row under the center, not whole
  const double middle = std::round(lowest);
  const auto aside = static_cast<int>(half_rows);
  SurfaceWindow nodes(pair.nodes.grid, {{-aside, aside}, {0, static_cast<int>(pair.half_nodes()) - 1}},
                      middle - lowest);
  Eigen::ArrayXd gap = initial_gap(nodes, 1.0, pair.pair);
  Eigen::ArrayXd lever = pressure_lever(nodes, pair.pair);
  Axes axes = axes_at(pair, nodes);
  return {.first = static_cast<Index>(middle) - half_rows,
          .count = 2 * half_rows + 1,
          .nodes = std::move(nodes),
          .gap = std::move(gap),
          .lever = std::move(lever),
          .axes = std::move(axes)};
}

}  // namespace viscoroll::detail
