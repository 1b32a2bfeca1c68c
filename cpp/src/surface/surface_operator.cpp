#include "surface/surface_operator.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace viscoroll::detail {
namespace {

/// Call function(node, row, column) for every node of a field.
template <class Function>
void for_nodes(const WindowField& field, const Function& function) {
  Eigen::Index node = 0;
  for (Eigen::Index row = 0; row < field.rows.size(); ++row) {
    for (Eigen::Index column = 0; column < field.columns.size(); ++column) function(node++, row, column);
  }
}

VectorField along_axes(const std::vector<std::array<WindowField, 3>>& directions, const Eigen::ArrayXXd& components) {
  VectorField result = VectorField::Zero(components.rows(), 3);
  for (std::size_t p = 0; p < directions.size(); ++p) {
    const auto part = components.col(static_cast<Eigen::Index>(p));
    for (const Axis axis : {kForward, kDown, kSideways}) {
      const WindowField& direction = directions[p][static_cast<std::size_t>(axis)];
      for_nodes(direction, [&](Eigen::Index node, Eigen::Index row, Eigen::Index column) {
        result(node, axis) += direction(row, column) * part[node];
      });
    }
  }
  return result;
}

}  // namespace

Displacements SurfaceOperator::displacements(const VectorField& force) const {
  return deforming() == Deforming::counterbody ? Displacements{.rolling = {}, .counterbody = displacement(force)}
                                               : Displacements{.rolling = displacement(force), .counterbody = {}};
}

double SurfaceOperator::slope_force(const VectorField& force) const {
  if (deforming() != Deforming::counterbody) return 0.0;
  const Eigen::Index row = shape().theta_nodes;
  const Eigen::ArrayXd depth = at_nodes(-displacement(force).col(kDown), row, collocation());
  return -(force.col(kDown) * patch_slope(depth, row, row_distance())).sum();
}

Losses SurfaceOperator::losses(double lost) const {
  return deforming() == Deforming::counterbody ? Losses{.counterbody = lost} : Losses{.rolling = lost};
}

Eigen::ArrayXXd LocalCompliance::loads(const VectorField& force) const {
  Eigen::ArrayXXd loads(force.rows(), static_cast<Eigen::Index>(directions.size()));
  for (std::size_t p = 0; p < directions.size(); ++p) {
    const auto& [forward, down, sideways] = directions[p];
    auto load = loads.col(static_cast<Eigen::Index>(p));
    for_nodes(down, [&](Eigen::Index node, Eigen::Index row, Eigen::Index column) {
      load[node] = forward(row, column) * force(node, kForward) + down(row, column) * force(node, kDown) +
                   sideways(row, column) * force(node, kSideways);
    });
  }
  return loads;
}

VectorField LocalCompliance::displacements(const Eigen::ArrayXXd& components) const {
  return along_axes(displaced_directions, components);
}

VectorField LocalCompliance::forces(const Eigen::ArrayXXd& loads) const { return along_axes(directions, loads); }

const NodeRows& SurfaceOperator::every_node(bool mirrored) const {
  std::optional<NodeRows>& nodes = every_node_[mirrored ? 1 : 0];
  if (nodes) return *nodes;
  const auto [rows, columns] = shape();
  std::vector<Eigen::Index> every;
  every.reserve(static_cast<std::size_t>(mirrored ? rows * (columns / 2 + 1) : rows * columns));
  for (Eigen::Index start = 0; start < shape().size(); start += columns) {
    for (Eigen::Index k = mirrored ? columns / 2 : 0; k < columns; ++k) every.push_back(start + k);
  }
  return nodes.emplace(shape(), every, mirrored);
}

Eigen::ArrayXd SurfaceOperator::normal_displacement(const Eigen::ArrayXd& pressing, bool mirrored) const {
  const NodeRows& nodes = every_node(mirrored);
  Eigen::VectorXd forces(nodes.count());
  for (Eigen::Index i = 0; i < forces.size(); ++i) forces[i] = pressing[nodes.node(i)];
  const Eigen::VectorXd moved = normal_displacement(nodes, forces);
  Eigen::ArrayXd result(pressing.size());
  for (int row = 0; row < nodes.rows(); ++row) {
    nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
      result[nodes.node(i)] = moved[i];
      if (mirrored) result[nodes.node(i) - 2 * k] = moved[i];
    });
  }
  return result;
}

double SurfaceOperator::normal_stiffness() const { return 1.0 / local().table(Entry::rr)(0, 0); }

double SurfaceOperator::slip_stiffness() const {
  const Table& forward = local().table(Entry::phiphi);
  return 1.0 / std::abs(forward(0, 0) - forward(-1, 0));
}

Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance) {
  const auto difference = [&](Eigen::Index rows) {
    const Eigen::Index count = values.size() - 2 * rows * row;
    return Eigen::ArrayXd((values.tail(count) - values.head(count)) / (2.0 * static_cast<double>(rows) * distance));
  };
  Eigen::ArrayXd slope = Eigen::ArrayXd::Zero(values.size());
  slope.segment(row, values.size() - 2 * row) = difference(1);
  const Eigen::Index inner = values.size() - 4 * row;
  if (inner <= 0) return slope;
  slope.segment(2 * row, inner) = 1.25 * slope.segment(2 * row, inner) - 0.25 * difference(2);
  return slope;
}

Eigen::ArrayXd at_nodes(const Eigen::ArrayXd& values, Eigen::Index row, double downstream) {
  const Eigen::Index inner = values.size() - 3 * row;
  if (downstream == 0.0 || inner <= 0) return values;
  constexpr std::array<double, 4> kRows{-2.0, -1.0, 0.0, 1.0};
  Eigen::ArrayXd result = values;
  result.segment(2 * row, inner).setZero();
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    double share = 1.0;
    for (std::size_t k = 0; k < kRows.size(); ++k) {
      if (k != i) share *= (kRows[k] + downstream) / (kRows[k] - kRows[i]);
    }
    result.segment(2 * row, inner) += share * values.segment(static_cast<Eigen::Index>(i) * row, inner);
  }
  return result;
}

}  // namespace viscoroll::detail
