#include "surface/sphere_operator.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace viscoroll::detail {
namespace {

using Tables = SphereOperator::Tables;

/// Number, in tables of thetas from -h to h, of the first column of a window.
int first_theta(const std::vector<SphereTable>& tables, const Window& window) {
  return (tables.front().theta_nodes() - 1) / 2 + window.theta.first;
}

SphereProduct make_product(const std::vector<SphereTable>& tables, const SurfaceOperator& surface) {
  const Execution& execution = surface.execution();
  return {surface.window().shape(), first_theta(tables, surface.window()), tables, execution.threads, execution.watch};
}

constexpr std::array<double, 3> kShare{0.25, 0.5, 0.25};

/// Every other node, loaded over patches of two spacings. A share of displacements is taken an offset further
/// downstream.
SphereTable with_wide_loads(const SphereTable& fine, int stride, double downstream = 0.0) {
  const std::array<double, 4> phi_share{0.25 * (1.0 - downstream), 0.5 - 0.25 * downstream, 0.25 + 0.25 * downstream,
                                        0.25 * downstream};
  const int last = downstream > 0.0 ? 2 : 1;
  const int half = ((fine.theta_nodes() - 1) / 2 - 1) / stride;
  const int middle = (fine.theta_nodes() - 1) / 2;
  SphereTable coarse((fine.phi_reach() - last) / stride, 2 * half + 1);
  for (int j = -coarse.phi_reach(); j <= coarse.phi_reach(); ++j) {
    for (int dj = -1; dj <= last; ++dj) {
      const Eigen::MatrixXd& slice = fine.slice(stride * j + dj);
      const double share = phi_share[static_cast<std::size_t>(dj + 1)];
      for (int to = -half; to <= half; ++to) {
        for (int from = -half; from <= half; ++from) {
          for (int dk = -1; dk <= 1; ++dk) {
            coarse.slice(j)(to + half, from + half) += share * kShare[static_cast<std::size_t>(dk + 1)] *
                                                       slice(middle + stride * to, middle + stride * from + dk);
          }
        }
      }
    }
  }
  return coarse;
}

/// The same nodes, displaced and loaded in each other's place.
SphereTable transposed(const SphereTable& table) {
  SphereTable result(table.phi_reach(), table.theta_nodes());
  for (int j = -table.phi_reach(); j <= table.phi_reach(); ++j) result.slice(-j) = table.slice(j).transpose();
  return result;
}

template <class Widen>
Tables widened(const std::vector<SphereTable>& fine, const Widen& widen) {
  std::vector<SphereTable> coarse;
  coarse.reserve(fine.size());
  for (const SphereTable& table : fine) coarse.push_back(widen(table));
  return std::make_shared<const std::vector<SphereTable>>(std::move(coarse));
}

}  // namespace

SphereOperator::SphereOperator(std::shared_ptr<const SurfaceOperator> nearby, Tables tables,
                               DissipationSource dissipation_source)
    : nearby_(std::move(nearby)),
      tables_(std::move(tables)),
      dissipation_source_(std::move(dissipation_source)),
      product_(make_product(*tables_, *nearby_)) {}

Eigen::ArrayXXd SphereOperator::loads(const VectorField& force) const {
  const auto& directions = local().directions;
  Eigen::ArrayXXd loads(force.rows(), static_cast<Eigen::Index>(directions.size()));
  for (std::size_t p = 0; p < directions.size(); ++p) {
    loads.col(static_cast<Eigen::Index>(p)) = directions[p][kForward] * force.col(kForward) +
                                              directions[p][kDown] * force.col(kDown) +
                                              directions[p][kSideways] * force.col(kSideways);
  }
  return loads;
}

VectorField SphereOperator::displacement(const VectorField& force) const {
  const auto& directions = local().displaced_directions;
  const Eigen::ArrayXXd components = product_.apply(loads(force), execution().threads, execution().watch);
  VectorField result = VectorField::Zero(force.rows(), 3);
  for (std::size_t p = 0; p < directions.size(); ++p) {
    for (const Axis axis : {kForward, kDown, kSideways}) {
      result.col(axis) += directions[p][static_cast<std::size_t>(axis)] * components.col(static_cast<Eigen::Index>(p));
    }
  }
  return result;
}

Eigen::VectorXd SphereOperator::normal_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  VectorField force = VectorField::Zero(shape().size(), 3);
  for (Eigen::Index i = 0; i < pressing.size(); ++i) force(nodes.node(i), kDown) = pressing[i];
  const Eigen::ArrayXd moved = displacement(force).col(kDown);
  return Eigen::VectorXd::NullaryExpr(pressing.size(), [&](Eigen::Index i) { return moved[nodes.node(i)]; });
}

std::shared_ptr<const SurfaceOperator> SphereOperator::coarsened() const {
  // What is loaded and what is displaced are both averages over wider patches where work is lost.
  const auto wide_power = [](const SphereTable& table) {
    return with_wide_loads(transposed(with_wide_loads(transposed(table), 1)), 2);
  };
  return std::make_shared<SphereOperator>(
      nearby_->coarsened(),
      widened(*tables_, [this](const SphereTable& table) { return with_wide_loads(table, 2, collocation()); }),
      [source = dissipation_source_, wide_power](int phi_reach, int half_theta) {
        return widened(*source(2 * phi_reach + 2, 2 * half_theta + 2), wide_power);
      });
}

std::shared_ptr<const SurfaceOperator> SphereOperator::within(const Window& window) const {
  return std::make_shared<SphereOperator>(nearby_->within(window), tables_, dissipation_source_);
}

Losses SphereOperator::dissipation(const VectorField& force) const {
  const int half_theta = std::max(-window().theta.first, window().theta.last);
  const Tables tables = dissipation_source_(shape().phi_nodes - 1, half_theta);
  const SphereProduct product = make_product(*tables, *nearby_);
  const Eigen::ArrayXXd loads = this->loads(force);
  return {.rolling = (loads * product.apply(loads, execution().threads, execution().watch)).sum()};
}

}  // namespace viscoroll::detail
