// Surfaces with periodic influence tables: products on the period, coarser meshes, boxes and the preconditioner.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "influence/table_product.hpp"
#include "surface/table_operator.hpp"

namespace {

using namespace viscoroll::detail;
using Eigen::Index;

Watch& unobserved() {
  static const viscoroll::Observer observer;
  static Watch watch(observer);
  return watch;
}

const Execution& one_thread() {
  static const Execution execution{1, unobserved()};
  return execution;
}

/// Table that is periodic along both directions, without symmetry along phi, even along theta. The displacement of the
/// loaded node itself is larger, so that the symbol has no zeros.
Table periodic_table(const WindowShape& period) {
  Table table(period.phi_nodes - 1, std::max(period.theta_nodes - 1, 0), false);
  for (int j = -table.phi_reach(); j <= table.phi_reach(); ++j) {
    for (int l = 0; l <= table.theta_reach(); ++l) {
      const double phi = 2.0 * std::numbers::pi * j / period.phi_nodes;
      const double theta = 2.0 * std::numbers::pi * l / period.theta_nodes;
      table.row(j)[static_cast<std::size_t>(l)] =
          (j % period.phi_nodes == 0 && l % period.theta_nodes == 0 ? 5.0 : 0.0) +
          std::exp(1.5 * std::cos(phi) + 1.2 * std::cos(theta)) + 0.3 * std::sin(phi) + 2.0;
    }
  }
  return table;
}

std::shared_ptr<const TableOperator> periodic_operator(const WindowShape& period) {
  const SurfaceGrid grid{.radius = 1.0, .phi_spacing = 0.1, .theta_spacing = 0.1, .is_paraboloid = true};
  const Window window{{0, period.phi_nodes - 1}, {0, period.theta_nodes - 1}};
  auto tables = std::make_shared<std::vector<Table>>(1, periodic_table(period));
  return std::make_shared<TableOperator>(
      Formulation{.compliance = viscoroll::Compliance::radial,
                  .patch_load = viscoroll::PatchLoad::flat,
                  .tangential = false,
                  .is_counterbody = true},
      grid, window, std::move(tables),
      [period](int, int) { return std::make_shared<const std::vector<Table>>(1, periodic_table(period)); },
      one_thread(), period);
}

VectorField random_force(Index nodes) {
  VectorField force = VectorField::Zero(nodes, 3);
  force.col(kDown) = Eigen::ArrayXd::Random(nodes);
  return force;
}

/// Displacements by summation over all pairs of nodes.
Eigen::ArrayXd summed(const Table& table, const WindowShape& shape, const Eigen::ArrayXd& force) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(force.size());
  for (Index to = 0; to < force.size(); ++to) {
    for (Index from = 0; from < force.size(); ++from) {
      const auto j = static_cast<int>(to / shape.theta_nodes - from / shape.theta_nodes);
      const auto l = static_cast<int>(to % shape.theta_nodes - from % shape.theta_nodes);
      sum[to] += table(j, l) * force[from];
    }
  }
  return sum;
}

class PeriodicSurface : public testing::TestWithParam<WindowShape> {};

TEST_P(PeriodicSurface, DisplacementsAreSumsOverThePeriod) {
  const WindowShape period = GetParam();
  const auto surface = periodic_operator(period);
  const VectorField force = random_force(period.size());
  const Eigen::ArrayXd expected = summed(periodic_table(period), period, force.col(kDown));
  const double round_off = 1e-12 * expected.abs().maxCoeff();
  EXPECT_LT((surface->displacement(force).col(kDown) - expected).abs().maxCoeff(), round_off);
  EXPECT_LT((surface->normal_displacement(force.col(kDown)) - expected).abs().maxCoeff(), round_off);
}

TEST_P(PeriodicSurface, DissipationIsASumOverThePeriod) {
  const WindowShape period = GetParam();
  const VectorField force = random_force(period.size());
  const double expected = (force.col(kDown) * summed(periodic_table(period), period, force.col(kDown))).sum();
  EXPECT_NEAR(periodic_operator(period)->dissipation(force).counterbody, expected, 1e-10 * std::abs(expected));
}

TEST_P(PeriodicSurface, ThePreconditionerIsTheExactInverse) {
  const WindowShape period = GetParam();
  const Table table = periodic_table(period);
  const VectorField force = random_force(period.size());
  const InverseConvolution inverse(period, period, {&table}, {{.result = 0, .table = 0, .operand = 0, .sign = 1.0}}, 1,
                                   unobserved());
  const Convolution product(period, period, std::vector{table}, {{.result = 0, .table = 0, .operand = 0, .sign = 1.0}},
                            1, unobserved());
  const Eigen::ArrayXXd back = product.apply(inverse.apply(force.col(kDown), 1, unobserved()), 1, unobserved());
  EXPECT_LT((back.col(0) - force.col(kDown)).abs().maxCoeff(), 1e-12);
}

TEST_P(PeriodicSurface, ABoxHasThePeriodOfTheWholeSurface) {
  const WindowShape period = GetParam();
  const auto whole = periodic_operator(period);
  const int columns = period.theta_nodes == 1 ? 1 : period.theta_nodes - 3;
  const Window box{{2, period.phi_nodes - 2}, {0, columns - 1}};
  const auto inside = whole->within(box);
  ASSERT_EQ(inside->period(), period);
  const VectorField force = random_force(box.shape().size());
  const Eigen::ArrayXd expected = summed(periodic_table(period), box.shape(), force.col(kDown));
  EXPECT_LT((inside->displacement(force).col(kDown) - expected).abs().maxCoeff(), 1e-12 * expected.abs().maxCoeff());
}

TEST_P(PeriodicSurface, ACoarseMeshIsPeriodicIfThePeriodIsEven) {
  const WindowShape period = GetParam();
  const auto coarse = periodic_operator(period)->coarsened();
  const bool even = period.phi_nodes % 2 == 0 && (period.theta_nodes == 1 || period.theta_nodes % 2 == 0);
  ASSERT_EQ(coarse->period().has_value(), even);
  if (!even) return;
  EXPECT_EQ(coarse->period(), coarse->shape());
  EXPECT_EQ(2 * coarse->shape().phi_nodes, period.phi_nodes);
  // A uniform pressure displaces all nodes equally, and forces on all nodes that add up to the same sum.
  const Index nodes = coarse->shape().size();
  VectorField force = VectorField::Zero(nodes, 3);
  force.col(kDown).setConstant(1.0 / static_cast<double>(nodes));
  const Eigen::ArrayXd moved = coarse->displacement(force).col(kDown);
  VectorField fine = VectorField::Zero(period.size(), 3);
  fine.col(kDown).setConstant(1.0 / static_cast<double>(period.size()));
  const double expected = periodic_operator(period)->displacement(fine)(0, kDown);
  EXPECT_LT((moved - expected).abs().maxCoeff(), 1e-12 * expected);
}

// The last shapes exceed the limit up to which products are sums over nodes.
INSTANTIATE_TEST_SUITE_P(Shapes, PeriodicSurface,
                         testing::Values(WindowShape{12, 10}, WindowShape{15, 14}, WindowShape{20, 1},
                                         WindowShape{80, 60}, WindowShape{77, 63}));

}  // namespace
