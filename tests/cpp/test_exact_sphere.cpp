// Legendre functions, and influence on the exact sphere by sums of its own kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases.hpp"
#include "influence/gauss_legendre.hpp"
#include "influence/legendre.hpp"
#include "influence/sphere_product.hpp"
#include "influence/sphere_sum.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// mpmath.legenp(l, m, cos(t)) * sqrt((2l+1) (l-m)! / (2 (l+m)!)) with 60 digits, without the sign (-1)^m.
TEST(LegendreFunctions, AgreeWithMpmath) {
  const auto value = [](int degree, int order, double theta) {
    return LegendreFunctions(order, degree, Eigen::ArrayXd::Constant(1, theta)).value(degree - order, 0);
  };
  EXPECT_NEAR(value(1, 0, 1.0), 0.661732478113054, 1e-12);
  EXPECT_NEAR(value(3, 2, 0.7), 0.813152088440889, 1e-12);
  EXPECT_NEAR(value(400, 37, 1.3), -0.74833703711548, 1e-11);
  EXPECT_NEAR(value(3000, 2000, 0.9), 0.295531517637442, 1e-10);
  // 0.53^2000 is below every double.
  EXPECT_NEAR(value(4000, 2000, 0.56), 0.443920413301403, 1e-10);
}

TEST(LegendreFunctions, AreOrthonormalAndHaveTheirSlopes) {
  const auto [x, weights] = gauss_legendre(200);
  const Eigen::ArrayXd theta = x.acos();
  for (const int order : {0, 1, 17}) {
    const LegendreFunctions p(order, 150, theta);
    const Eigen::MatrixXd gram = p.value * weights.matrix().asDiagonal() * p.value.transpose();
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-11);
    constexpr double kStep = 1e-6;
    const LegendreFunctions ahead(order, 150, theta + kStep);
    const LegendreFunctions behind(order, 150, theta - kStep);
    const Eigen::MatrixXd slope = (ahead.value - behind.value) / (2.0 * kStep);
    EXPECT_LT((slope - p.slope).cwiseAbs().maxCoeff(), 1e-5 * p.slope.cwiseAbs().maxCoeff());
  }
}

class SphereSumTest : public testing::TestWithParam<CoatedSphere> {
 protected:
  static constexpr int kReach = 12;
  static constexpr int kHalf = 6;

  [[nodiscard]] SphereInfluence influence(double exact_degree, const SphereRequest& request) {
    return SphereSum(GetParam(), 2.5, {.nodes_per_revolution = 200}, exact_degree)
        .influences({request}, kReach, kHalf, 2, watch_)
        .front();
  }

  /// [j][to, from] of one entry, from the factors one by one.
  static std::vector<Eigen::MatrixXd> table(const SphereInfluence& influence, std::size_t entry) {
    const Index nodes = influence.root.size();
    const std::size_t tables = influence.powers == 0 ? 0 : influence.local.size() / influence.powers;
    const SignedEntry source = entry_of(entry / 3, entry % 3);
    std::vector<Eigen::MatrixXd> slices;
    for (int j = -influence.phi_reach(); j <= influence.phi_reach(); ++j) {
      Eigen::MatrixXd slice = influence.displaced * influence.degrees[entry].slice(j) * influence.loaded.transpose();
      for (std::size_t power = 0; power < influence.powers; ++power) {
        const Table& local = influence.local[power * tables + static_cast<std::size_t>(source.entry)];
        for (Index to = 0; to < nodes; ++to) {
          for (Index from = 0; from < nodes; ++from) {
            slice(to, from) += source.sign * local(j, static_cast<int>(to - from)) *
                               std::pow(influence.root[to] * influence.root[from], static_cast<double>(power) - 1.0);
          }
        }
      }
      slices.push_back(slice);
    }
    return slices;
  }
  static double difference(const std::vector<Eigen::MatrixXd>& a, const std::vector<Eigen::MatrixXd>& b) {
    double largest = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, (a[j] - b[j]).cwiseAbs().maxCoeff());
    return largest;
  }

  Observer observer_;
  Watch watch_{observer_};
};

/// What is summed by degrees and what with the local metric make up the same, wherever they meet: to the square of the
/// degree for r by r, and for directions along the surface, which turn by cos(theta) per phi, to cos(theta) per degree.
TEST_P(SphereSumTest, DoesNotDependOnWhereDegreesEnd) {
  constexpr double kCoarse = 32.0;
  const double turn = std::sin(6.0 * 2.0 * std::numbers::pi / 200.0);
  for (const bool power : {false, true}) {
    const SphereRequest request{.tangential = true, .power = power, .patch_load = PatchLoad::spherical};
    const SphereInfluence coarse = influence(kCoarse, request);
    const SphereInfluence fine = influence(96.0, request);
    const auto diagonal = table(fine, 0);
    for (std::size_t t = 0; t < fine.degrees.size(); ++t) {
      const auto entry = table(fine, t);
      const double size = (t % 4 == 0 ? entry : diagonal)[kReach + (power ? 1 : 0)].cwiseAbs().maxCoeff();
      EXPECT_LT(difference(table(coarse, t), entry), (t == 0 ? 0.3 / kCoarse : 1.2 * turn) / kCoarse * size)
          << "entry " << t << ", power " << power;
    }
  }
}

/// Between few thetas as between all nodes: those of a mesh so fine that waves vary slowly from node to node.
TEST_P(SphereSumTest, FewThetasDo) {
  const Mesh mesh{.nodes_per_revolution = 1600};
  for (const bool power : {false, true}) {
    const SphereRequest request{
        .tangential = true, .power = power, .patch_load = PatchLoad::spherical, .collocation = 0.1};
    constexpr int kFew = 16;
    const SphereSum sum(GetParam(), 2.5, mesh, kFew);
    const SphereInfluence few = sum.influences({request}, 4, 60, 2, watch_).front();
    ASSERT_LT(few.degrees.front().thetas(), 40);
    // Of so few nodes that each is a theta of its own.
    const SphereInfluence all = sum.influences({request}, 4, 3, 2, watch_).front();
    ASSERT_EQ(all.degrees.front().thetas(), 7);
    for (std::size_t t = 0; t < all.degrees.size(); ++t) {
      for (const int j : {-4, 0, 3}) {
        const Eigen::MatrixXd between_few = few.displaced * few.degrees[t].slice(j) * few.loaded.transpose();
        const Eigen::MatrixXd between_all = all.displaced * all.degrees[t].slice(j) * all.loaded.transpose();
        EXPECT_LT((between_few.block(57, 57, 7, 7) - between_all).cwiseAbs().maxCoeff(),
                  1e-7 * all.degrees[0].slice(power ? 3 : 0).cwiseAbs().maxCoeff())
            << "entry " << t << ", power " << power;
      }
    }
  }
}

TEST_P(SphereSumTest, ProductsAreSumsOverNodes) {
  const SphereRequest request{.tangential = true, .power = false};
  const SphereInfluence all = influence(32.0, request);
  const WindowShape shape{.phi_nodes = 9, .theta_nodes = 5};
  constexpr int kFirst = 4;  // of 13 columns
  const SphereProduct in_factors(shape, kFirst, all, 2, watch_);
  const SphereProduct in_one = make_sphere_product(shape, kFirst, all, 2, watch_);
  ASSERT_LT(in_one.operations(), in_factors.operations());
  const Eigen::ArrayXXd loads = Eigen::ArrayXXd::Random(shape.size(), 3);
  Eigen::ArrayXXd sums = Eigen::ArrayXXd::Zero(shape.size(), 3);
  for (std::size_t t = 0; t < 9; ++t) {
    const auto slices = table(all, t);
    for (Index node = 0; node < shape.size(); ++node) {
      for (Index from = 0; from < shape.size(); ++from) {
        const Index offset = node / shape.theta_nodes - from / shape.theta_nodes;
        sums(node, static_cast<Index>(t / 3)) +=
            slices[static_cast<std::size_t>(kReach + offset)](kFirst + node % shape.theta_nodes,
                                                              kFirst + from % shape.theta_nodes) *
            loads(from, static_cast<Index>(t % 3));
      }
    }
  }
  for (const SphereProduct* product : {&in_factors, &in_one}) {
    EXPECT_LT((product->apply(loads, 2, watch_) - sums).abs().maxCoeff(), 1e-12 * sums.abs().maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Coatings, SphereSumTest,
    testing::Values(
        cases::paper_sphere(0.0),
        CoatedSphere{.core_radius = 4e-3,
                     .layers = {{.thickness = 16e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}}},
        CoatedSphere{.layers = {{.thickness = 20e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.3}},
                     .inner_boundary = InnerBoundary::solid}));

}  // namespace
}  // namespace viscoroll::detail
