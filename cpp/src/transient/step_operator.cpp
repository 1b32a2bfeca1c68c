#include "transient/step_operator.hpp"

#include <Eigen/LU>
#include <array>
#include <span>

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

/// Vector field with a given component along a direction.
HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar) {
  HalfField field(3 * scalar.rows(), scalar.cols());
  field << direction[0].cwiseProduct(scalar), direction[1].cwiseProduct(scalar), direction[2].cwiseProduct(scalar);
  return field;
}

/// Sum over the parts; a single part with a share of 1 is not changed.
template <class Field, class Parts>
Field summed(const Parts& parts, const auto& field) {
  Field sum = field(parts.front());
  if (parts.front().share != 1.0) sum *= parts.front().share;
  for (const auto& part : std::span(parts).subspan(1)) sum += part.share * field(part);
  return sum;
}

/// Directions of the plane at a node, one in each row, by their components.
Matrix3d axes_of(const Axes& axes, Index node) {
  Matrix3d rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t p = 0; p < 3; ++p) {
      rows(static_cast<Index>(axis), static_cast<Index>(p)) = axes[axis][p].data()[node];
    }
  }
  return rows;
}

/// Compliance along the axes, from the compliance of the components.
MatrixXd along_axes(MatrixXd compliance, const Axes& axes, const std::vector<Index>& displaced,
                    const std::vector<Index>& loaded) {
  for (std::size_t i = 0; i < displaced.size(); ++i) {
    auto rows = compliance.middleRows<3>(static_cast<Index>(3 * i));
    rows = (axes_of(axes, displaced[i]) * rows).eval();
  }
  for (std::size_t j = 0; j < loaded.size(); ++j) {
    auto columns = compliance.middleCols<3>(static_cast<Index>(3 * j));
    columns = (columns * axes_of(axes, loaded[j]).transpose()).eval();
  }
  return compliance;
}

struct LoadedRows {
  Index first;
  Index last;
};

LoadedRows loaded_rows(const VectorField& force, Index half_nodes) {
  const auto is_loaded = [&](Index node) { return (force.row(node) != 0.0).any(); };
  Index first = 0;
  Index last = force.rows() - 1;
  while (first < last && !is_loaded(first)) ++first;
  while (first < last && !is_loaded(last)) --last;
  return {.first = first / half_nodes, .last = last / half_nodes};
}

/// Add the displacement along the axes. Tables use the forces of the rolling body on the counterbody.
void add_displacement(double share, const Axes& axes, const HalfField& displaced, VectorField& sum) {
  for (const Axis axis : {kForward, kDown, kSideways}) {
    const HalfField moved = along(axes[static_cast<std::size_t>(axis)], displaced);
    sum.col(axis) -= share * moved.reshaped().array();
  }
}

}  // namespace

HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field) {
  const Eigen::Index half_nodes = direction[0].rows();
  HalfField result = direction[0].cwiseProduct(field.topRows(half_nodes));
  result += direction[1].cwiseProduct(field.middleRows(half_nodes, half_nodes));
  result += direction[2].cwiseProduct(field.bottomRows(half_nodes));
  return result;
}

HalfField on_plane(const Axes& axes, const VectorField& force) {
  const auto part = [&](std::size_t axis) {
    return spread(axes[axis], as_field(-force.col(static_cast<Eigen::Index>(axis)), axes[axis][0].rows()));
  };
  return part(kDown) + part(kForward) + part(kSideways);
}

double StepOperator::diagonal_compliance() const {
  double sum = 0.0;
  for (const Part& part : parts_) sum += part.share * part.tables->diagonal_compliance();
  return sum;
}

double StepOperator::compliance_along(Index node) const {
  double sum = 0.0;
  for (const Part& part : parts_)
    sum += part.share * part.tables->compliance({node}, {node}, (*part.axes)[kForward])(0, 0);
  return sum;
}

MatrixXd StepOperator::normal_compliance(const std::vector<Index>& displaced, const std::vector<Index>& loaded) const {
  return summed<MatrixXd>(
      parts_, [&](const Part& part) { return part.tables->compliance(displaced, loaded, (*part.axes)[kDown]); });
}

HalfField StepOperator::normal_displacement(const HalfField& pressing, Index first, Index last) const {
  return summed<HalfField>(parts_, [&](const Part& part) {
    if (part.tables->components() == 1) return part.tables->displacement(pressing, first, last, checkpoint_);
    const std::array<HalfField, 3>& down = (*part.axes)[kDown];
    return along(down, part.tables->displacement(spread(down, pressing), first, last, checkpoint_));
  });
}

std::vector<double> StepOperator::shares() const {
  std::vector<double> shares;
  shares.reserve(parts_.size());
  for (const Part& part : parts_) shares.push_back(part.share);
  return shares;
}

StepOperator StepOperator::with_shares(const std::vector<double>& shares) const {
  std::vector<Part> parts = parts_;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].share = shares[i];
  return {std::move(parts), checkpoint_};
}

Matrix3d StepOperator::to_frame(Index node) const {
  return is_single() ? Matrix3d(axes_of(*parts_.front().axes, node).inverse()) : Matrix3d::Identity();
}

MatrixXd StepOperator::compliance(const std::vector<Index>& displaced, const std::vector<Index>& loaded) const {
  return summed<MatrixXd>(parts_, [&](const Part& part) {
    MatrixXd components = part.tables->compliance(displaced, loaded);
    return is_single() ? components : along_axes(std::move(components), *part.level_axes, displaced, loaded);
  });
}

std::vector<HalfField> StepOperator::displaced(const VectorField& force) const {
  std::vector<HalfField> displaced;
  displaced.reserve(parts_.size());
  const LoadedRows rows = loaded_rows(force, half_nodes());
  for (const Part& part : parts_) {
    displaced.push_back(part.tables->displacement(on_plane(*part.axes, force), rows.first, rows.last, checkpoint_));
  }
  return displaced;
}

VectorField StepOperator::displacement(const std::vector<HalfField>& displaced) const {
  VectorField sum = VectorField::Zero(displaced.front().cols() * half_nodes(), 3);
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    add_displacement(parts_[b].share, *parts_[b].axes, displaced[b], sum);
  }
  return sum;
}

VectorField StepOperator::excess(const VectorField& force, const std::vector<HalfField>& displaced) const {
  VectorField excess = displacement(displaced);
  const LoadedRows rows = loaded_rows(force, half_nodes());
  for (const Part& part : parts_) {
    const HalfField level =
        part.tables->displacement(on_plane(*part.level_axes, force), rows.first, rows.last, checkpoint_);
    add_displacement(-part.share, *part.level_axes, level, excess);
  }
  return excess;
}

}  // namespace viscoroll::detail
