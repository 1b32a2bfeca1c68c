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
  [[nodiscard]] std::vector<SphereTable> tables(double exact_degree, const SphereRequest& request) {
    return SphereSum(GetParam(), 2.5, {.nodes_per_revolution = 200}, exact_degree)
        .tables({request}, 12, 6, 2, watch_)
        .front();
  }
  static double difference(const SphereTable& a, const SphereTable& b) {
    double largest = 0.0;
    for (int j = -a.phi_reach(); j <= a.phi_reach(); ++j) {
      largest = std::max(largest, (a.slice(j) - b.slice(j)).cwiseAbs().maxCoeff());
    }
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
    const auto coarse = tables(kCoarse, request);
    const auto fine = tables(96.0, request);
    for (std::size_t t = 0; t < fine.size(); ++t) {
      const double size = fine[t % 4 == 0 ? t : 0].slice(power ? 1 : 0).cwiseAbs().maxCoeff();
      EXPECT_LT(difference(coarse[t], fine[t]), (t == 0 ? 0.3 / kCoarse : 1.2 * turn) / kCoarse * size)
          << "entry " << t << ", power " << power;
    }
  }
}

TEST_P(SphereSumTest, ProductsAreSumsOverNodes) {
  const SphereRequest request{.tangential = true, .power = false};
  const auto all = tables(32.0, request);
  const WindowShape shape{.phi_nodes = 9, .theta_nodes = 5};
  constexpr int kFirst = 4;  // of 13 columns
  const SphereProduct product(shape, kFirst, all, 2, watch_);
  const Eigen::ArrayXXd loads = Eigen::ArrayXXd::Random(shape.size(), 3);
  const Eigen::ArrayXXd moved = product.apply(loads, 2, watch_);
  for (Index p = 0; p < 3; ++p) {
    for (Index node = 0; node < shape.size(); ++node) {
      double sum = 0.0;
      for (Index q = 0; q < 3; ++q) {
        for (Index from = 0; from < shape.size(); ++from) {
          const auto offset = static_cast<int>(node / shape.theta_nodes - from / shape.theta_nodes);
          sum += all[static_cast<std::size_t>(3 * p + q)].slice(offset)(kFirst + node % shape.theta_nodes,
                                                                        kFirst + from % shape.theta_nodes) *
                 loads(from, q);
        }
      }
      EXPECT_NEAR(moved(node, p), sum, 1e-12 * all[0].slice(0).maxCoeff());
    }
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
