// Legendre functions, and influence on the exact sphere compared with independent sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "cases.hpp"
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
  // The factor sin(theta)^2000 = 0.53^2000 is below the smallest double.
  EXPECT_NEAR(value(4000, 2000, 0.56), 0.443920413301403, 1e-10);
}

TEST(LegendreFunctions, AreOrthonormalWithCorrectSlopes) {
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
    return SphereSum(layered_body(GetParam()), 2.5, Mesh{.nodes_per_revolution = 200}, exact_degree)
        .influences({request}, kReach, kHalf, 2, watch_)
        .front();
  }

  /// Table [j][to, from] of one entry, summed over single orders and powers.
  static std::vector<Eigen::MatrixXd> table(const SphereInfluence& influence, std::size_t entry) {
    const Index nodes = influence.root.size();
    const std::size_t tables = influence.powers == 0 ? 0 : influence.local.size() / influence.powers;
    const SignedEntry source = entry_of(entry / 3, entry % 3);
    std::vector<Eigen::MatrixXcd> orders;
    orders.reserve(influence.orders.size());
    for (const SphericalOrder& order : influence.orders) {
      orders.push_back(
          sum_between(order, static_cast<int>(entry / 3), static_cast<int>(entry % 3), influence.half_theta()));
    }
    std::vector<Eigen::MatrixXd> slices;
    slices.reserve(static_cast<std::size_t>(2 * influence.phi_reach + 1));
    for (int j = -influence.phi_reach; j <= influence.phi_reach; ++j) {
      Eigen::MatrixXd slice = Eigen::MatrixXd::Zero(nodes, nodes);
      for (std::size_t m = 0; m < orders.size(); ++m) {
        slice += (std::polar(1.0, static_cast<double>(m) * j * influence.phi_spacing) * orders[m]).real();
      }
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

  /// Assert the sums over the nodes of a window that begins at `first_theta`, counted from the equator.
  void expect_sums_over_nodes(const SphereInfluence& influence, WindowShape shape, int first_theta) {
    const FactoredSphereProduct in_factors(shape, first_theta, std::make_shared<const SphereInfluence>(influence), 2,
                                           watch_);
    const JointSphereProduct in_one(shape, first_theta, influence, 2, watch_);
    const auto components = static_cast<Index>(influence.components());
    const Eigen::ArrayXXd loads = Eigen::ArrayXXd::Random(shape.size(), components);
    Eigen::ArrayXXd sums = Eigen::ArrayXXd::Zero(shape.size(), components);
    for (Index p = 0; p < components; ++p) {
      for (Index q = 0; q < components; ++q) {
        const auto slices = table(influence, static_cast<std::size_t>(3 * p + q));
        const Index first = influence.half_theta() + first_theta;
        for (Index node = 0; node < shape.size(); ++node) {
          for (Index from = 0; from < shape.size(); ++from) {
            const Index offset = node / shape.theta_nodes - from / shape.theta_nodes;
            const Eigen::MatrixXd& slice = slices[static_cast<std::size_t>(influence.phi_reach + offset)];
            sums(node, p) += slice(first + node % shape.theta_nodes, first + from % shape.theta_nodes) * loads(from, q);
          }
        }
      }
    }
    for (const SphereProduct* product :
         {static_cast<const SphereProduct*>(&in_factors), static_cast<const SphereProduct*>(&in_one)}) {
      EXPECT_LT((product->apply(loads, 2, watch_) - sums).abs().maxCoeff(), 1e-12 * sums.abs().maxCoeff());
    }
  }

  Observer observer_;
  Watch watch_{observer_};
};

/// The sum over degrees and the sum with the local metric give the same result for any transition degree. The error for
/// the r-r entry is of second order in the inverse degree. For tangential directions, which turn by cos(theta) per phi,
/// it is of the order of cos(theta) per degree.
TEST_P(SphereSumTest, DoesNotDependOnTheTransitionDegree) {
  constexpr double kCoarse = 32.0;
  const double turn = std::sin(6.0 * 2.0 * std::numbers::pi / 200.0);
  for (const bool power : {false, true}) {
    const SphereRequest request{.tangential = true, .power = power, .patch_load = PatchLoad::spherical};
    const SphereInfluence coarse = influence(kCoarse, request);
    const SphereInfluence fine = influence(96.0, request);
    const auto diagonal = table(fine, 0);
    for (std::size_t t = 0; t < 9; ++t) {
      const auto entry = table(fine, t);
      const double size = (t % 4 == 0 ? entry : diagonal)[kReach + (power ? 1 : 0)].cwiseAbs().maxCoeff();
      EXPECT_LT(difference(table(coarse, t), entry), (t == 0 ? 0.3 / kCoarse : 1.2 * turn) / kCoarse * size)
          << "entry " << t << ", power " << power;
    }
  }
}

/// Sums over the degrees between all thetas, with harmonics evaluated one by one, on both sides of the equator.
TEST_P(SphereSumTest, OneSideOfTheEquatorDeterminesTheSums) {
  const SphereRequest request{.tangential = true, .patch_load = PatchLoad::spherical};
  const SphereInfluence all = influence(32.0, request);
  constexpr int kOrder = 3;
  const SphericalOrder& order = all.orders[kOrder];
  const int highest = static_cast<int>(all.orders.size()) - 1;
  const double spacing = 2.0 * std::numbers::pi / 200.0;
  const Eigen::ArrayXd nodes =
      0.5 * std::numbers::pi + spacing * Eigen::ArrayXd::LinSpaced(2 * kHalf + 1, -kHalf, kHalf);
  const auto [x, weights] = gauss_legendre(20);
  /// d and e of a degree at all nodes, or their means over patches.
  const auto harmonics = [&](Index degree, bool means) {
    Eigen::MatrixXd of = Eigen::MatrixXd::Zero(nodes.size(), 2);
    const auto l = static_cast<double>(kOrder + degree);
    for (Index point = 0; point < (means ? x.size() : 1); ++point) {
      const Eigen::ArrayXd theta = nodes + (means ? 0.5 * spacing * x[point] : 0.0);
      const LegendreFunctions p(kOrder, highest, theta);
      const double weight = (means ? 0.5 * weights[point] : 1.0) / std::sqrt(l * (l + 1.0));
      of.col(0) += weight * p.slope.row(degree).transpose();
      of.col(1) += weight * kOrder * (p.value.row(degree).transpose().array() / theta.sin()).matrix();
    }
    return of;
  };
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(nodes.size(), nodes.size());  // phi by theta
  for (Index degree = 0; degree <= highest - kOrder; ++degree) {
    const EveryOtherDegree& own = order[static_cast<std::size_t>(degree % 2)];
    const Eigen::MatrixXd seen = harmonics(degree, false);
    const Eigen::MatrixXd loaded = harmonics(degree, true);
    sum += std::complex<double>(0.0, 1.0) * (own.along[degree / 2] * seen.col(1) * loaded.col(0).transpose() +
                                             own.across[degree / 2] * seen.col(0) * loaded.col(1).transpose());
  }
  const Eigen::MatrixXcd folded = sum_between(order, 1, 2, kHalf);
  EXPECT_LT((folded - sum).cwiseAbs().maxCoeff(), 1e-11 * sum.cwiseAbs().maxCoeff());
  const Eigen::VectorXcd across = sum_across_equator(order, 1, 2, 2 * kHalf);
  for (int l = 0; l <= 2 * kHalf; ++l) {
    EXPECT_LT(std::abs(across[l] - sum(kHalf + (l + 1) / 2, kHalf - l / 2)), 1e-11 * sum.cwiseAbs().maxCoeff());
  }
}

/// Tables of every other node are averages with weights of a quarter, a half and a quarter. The local tables neglect
/// the variation of the metric over a patch, so only the degrees are compared.
TEST_P(SphereSumTest, WidePatchesAreAveragesOfNarrowOnes) {
  for (const bool power : {false, true}) {
    const SphereRequest request{.tangential = true, .power = power, .patch_load = PatchLoad::flat};
    const SphereInfluence fine =
        SphereSum(layered_body(GetParam()), 2.5, Mesh{.nodes_per_revolution = 200, .max_order = 40})
            .influences({request}, kReach, kHalf, 2, watch_)
            .front();
    const double downstream = power ? 0.0 : 0.3;
    const SphereInfluence coarse = with_wide_patches(fine, downstream, power);
    const Index count = coarse.root.size();
    Eigen::MatrixXd same = Eigen::MatrixXd::Zero(count, fine.root.size());
    Eigen::MatrixXd mean = same;
    for (Index k = 0; k < count; ++k) {
      const Index node = kHalf + 2 * (k - coarse.half_theta());
      same(k, node) = 1.0;
      mean.row(k).segment(node - 1, 3) << 0.25, 0.5, 0.25;
    }
    // For the dissipation, the displacement is a mean over the patch as well.
    const Eigen::MatrixXd& measured = power ? mean : same;
    const std::array<double, 3> seen_shares = power ? std::array{0.25, 0.5, 0.25} : std::array{0.0, 1.0, 0.0};
    const auto loaded_shares = wide_patch_shares(downstream);
    for (const std::size_t entry : {std::size_t{0}, std::size_t{5}, std::size_t{7}}) {
      const auto narrow = table(fine, entry);
      const auto wide = table(coarse, entry);
      for (const int j : {-2, 0, 1}) {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(count, count);
        for (int from = -1; from <= 2; ++from) {
          for (int to = -1; to <= 1; ++to) {
            sum += loaded_shares[static_cast<std::size_t>(from + 1)] * seen_shares[static_cast<std::size_t>(to + 1)] *
                   measured * narrow[static_cast<std::size_t>(kReach + 2 * j + from + to)] * mean.transpose();
          }
        }
        EXPECT_LT((wide[static_cast<std::size_t>(coarse.phi_reach + j)] - sum).cwiseAbs().maxCoeff(),
                  1e-12 * narrow[kReach + 1].cwiseAbs().maxCoeff())
            << "entry " << entry << ", power " << power << ", offset " << j;
      }
    }
  }
}

TEST_P(SphereSumTest, ProductsAgreeWithSumsOverNodes) {
  for (const bool tangential : {true, false}) {
    for (const bool power : {true, false}) {
      const SphereInfluence fine = influence(32.0, {.tangential = tangential, .power = power});
      expect_sums_over_nodes(fine, {.phi_nodes = 9, .theta_nodes = 5}, -3);
      expect_sums_over_nodes(fine, {.phi_nodes = 4, .theta_nodes = 3}, 2);  // on one side of the equator
      expect_sums_over_nodes(with_wide_patches(fine, 0.0, power), {.phi_nodes = 4, .theta_nodes = 5}, -2);
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
