#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

#include "cases.hpp"
#include "contact/coating_compliance.hpp"
#include "contact/surface_window.hpp"
#include "influence/patch.hpp"
#include "influence/synthesis.hpp"

namespace viscoroll::detail {
namespace {

/// Integral of f over [-1, 1] by 64 midpoint panels with Richardson extrapolation.
template <class Function>
double integral(const Function& f) {
  const auto midpoints = [&](int panels) {
    double sum = 0.0;
    for (int i = 0; i < panels; ++i) sum += f(-1.0 + (2.0 * i + 1.0) / panels) * 2.0 / panels;
    return sum;
  };
  const double coarse = (4.0 * midpoints(128) - midpoints(64)) / 3.0;
  const double fine = (4.0 * midpoints(256) - midpoints(128)) / 3.0;
  return (16.0 * fine - coarse) / 15.0;
}

TEST(Patch, SphericalBesselIsTheTransformOfLegendre) {
  for (const double x : {1e-5, 0.05, 0.099, 0.101, 0.199, 0.201, 1.0, 3.0}) {
    EXPECT_NEAR(spherical_bessel(0, x), 0.5 * integral([x](double t) { return std::cos(x * t); }), 1e-12);
    EXPECT_NEAR(spherical_bessel(1, x), 0.5 * integral([x](double t) { return t * std::sin(x * t); }), 1e-12);
    const auto second = [x](double t) { return (0.5 - 1.5 * t * t) * std::cos(x * t); };
    EXPECT_NEAR(spherical_bessel(2, x), 0.5 * integral(second), 1e-12);
  }
}

TEST(Patch, SphericalWeightsGiveTheInverseSine) {
  const double spacing = 0.02;
  const double theta = 1.3;
  const auto w = spherical_patch_weights(theta, spacing);
  for (const double x : {-1.0, -0.3, 0.0, 0.8}) {
    const double series = w[0] + w[1] * x + w[2] * (1.5 * x * x - 0.5);
    // Left out: third Legendre coefficient, about (spacing / 2)^3.
    EXPECT_NEAR(series, 1.0 / std::sin(theta + 0.5 * spacing * x), 1e-6);
  }
}

class CoatingTest : public testing::TestWithParam<std::tuple<Compliance, PatchLoad, bool>> {
 protected:
  CoatingTest() {
    const OrderSum orders(cases::unlike_layers(), 2.5, mesh_, 2, watch_);
    tables_ =
        std::make_shared<const std::vector<Table>>(orders.tables(displacement_tables(formulation_), 8, 10, 2, watch_));
    lost_work_tables_ = orders.tables(lost_work_tables(formulation_), 8, 10, 2, watch_);
  }

  /// Forces that vary from node to node, pressing alone where nothing tangential was asked for.
  [[nodiscard]] VectorField forces(double frequency) const {
    VectorField force = VectorField::Zero(window_.shape().size(), 3);
    force.col(kDown) = Eigen::ArrayXd::LinSpaced(force.rows(), 0.0, frequency).sin();
    if (formulation_.tangential) {
      force.col(kForward) = Eigen::ArrayXd::LinSpaced(force.rows(), 1.0, 2.0 * frequency).sin();
      force.col(kSideways) = Eigen::ArrayXd::LinSpaced(force.rows(), 2.0, 0.7 * frequency).cos();
    }
    return force;
  }

  Formulation formulation_{std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
  Mesh mesh_{.nodes_per_revolution = 101, .max_order = 130};
  SurfaceGrid grid_{23e-3, phi_spacing(mesh_), theta_spacing(mesh_)};
  SurfaceWindow window_{grid_, {-4, 4}, {-5, 5}};
  std::shared_ptr<const std::vector<Table>> tables_;
  std::vector<Table> lost_work_tables_;
  Observer observer_;
  Watch watch_{observer_};
  Execution execution_{2, watch_};
};

TEST_P(CoatingTest, FftProductEqualsTheDenseBlock) {
  const CoatingCompliance coating(formulation_, window_, tables_, execution_);
  std::vector<Eigen::Index> all(static_cast<std::size_t>(window_.shape().size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Eigen::Index>(i);
  const VectorField force = forces(1.0);
  const VectorField fast = coating.displacement(force);
  const Eigen::MatrixXd dense = coating.block(all, all, std::array{kForward, kDown, kSideways});
  const Eigen::VectorXd expected = dense * force.matrix().reshaped();
  EXPECT_LT((fast.matrix().reshaped() - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());

  const Eigen::MatrixXd vertical = coating.block(all, all, std::array{kDown});
  const auto count = window_.shape().size();
  EXPECT_EQ(vertical, dense.block(count, count, count, count));

  const Eigen::ArrayXd pressing = force.col(kDown);
  const Eigen::ArrayXd rise = coating.vertical_displacement(pressing);
  EXPECT_LT((rise - (vertical * pressing.matrix()).array()).abs().maxCoeff(), 1e-13 * rise.abs().maxCoeff());
}

TEST_P(CoatingTest, ForcesLoseNoEnergyToThePlane) {
  // Passivity: the compliance has a positive symmetric part, and the work lost is never negative.
  const CoatingCompliance coating(formulation_, window_, tables_, execution_);
  for (int k = 1; k < 40; ++k) {
    const VectorField force = forces(3.7 * k);
    EXPECT_GT((force * coating.displacement(force)).sum(), 0.0);
    EXPECT_GT(lost_work(formulation_, window_, lost_work_tables_, force, execution_), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Formulations, CoatingTest,
                         testing::Combine(testing::Values(Compliance::vertical, Compliance::radial),
                                          testing::Values(PatchLoad::flat, PatchLoad::spherical), testing::Bool()));

TEST(Synthesis, DoesNotDependOnTheNumberOfThreads) {
  const Mesh mesh{.nodes_per_revolution = 64, .max_order = 100};
  const auto sum = [&](int threads) {
    return influence_tables(cases::paper_sphere(), 2.5, mesh, 10, 12, threads).values;
  };
  EXPECT_EQ(sum(1), sum(2));
  EXPECT_EQ(sum(1), sum(5));
}

/// The same orders as `octaves`, one by one: the sum that the octaves abbreviate.
std::vector<OrderBand> one_by_one(const std::vector<OrderBand>& octaves, int nodes_per_revolution) {
  const auto& last = octaves.back().orders;
  const auto count = static_cast<Eigen::Index>(last[last.size() - 1]);
  // The octaves telescope: their weights add up to the last step, of which the highest orders show the middle.
  const double middle = 16.0 * nodes_per_revolution;
  const Eigen::ArrayXd orders = Eigen::ArrayXd::LinSpaced(count + 1, 0.0, static_cast<double>(count));
  Eigen::ArrayXd weights =
      2.0 * orders.unaryExpr([&](double order) { return 0.5 * std::erfc((order - middle) * 4.8 / middle); });
  weights[0] *= 0.5;
  return {{.orders = orders, .weights = weights, .reach = nodes_per_revolution / 2}};
}

struct OctaveCase {
  const char* name;
  CoatedSphere sphere;
  double angular_speed;
  int phi_nodes;
  int theta_nodes;
};

void PrintTo(const OctaveCase& c, std::ostream* out) { *out << c.name; }

/// A modulus known at two frequencies a decade, with a steep rise: linear in between, so with kinks.
CoatedSphere measured_sphere() {
  MasterCurve curve{.frequency = {0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 150.0, 300.0, 1000.0},
                    .storage = {1e6, 1e6, 1.1e6, 1.2e6, 1.4e6, 1.7e6, 2e6, 2.2e6, 7e6, 8e6, 8e6},
                    .loss = {0.0, 1e4, 5e4, 2e5, 3e5, 4e5, 5e5, 6e5, 3e6, 4e5, 1e5},
                    .extrapolation = Extrapolation::hold};
  return {.core_radius = 20e-3,
          .layers = {{.thickness = 1e-3, .shear_modulus = std::move(curve), .poisson_ratio = 0.5}}};
}

class OctavesTest : public testing::TestWithParam<OctaveCase> {};

TEST_P(OctavesTest, AgreeWithTheSumOfAllOrders) {
  const OctaveCase& c = GetParam();
  const Mesh mesh{.nodes_per_revolution = c.phi_nodes, .theta_nodes_per_revolution = c.theta_nodes};
  const Observer observer;
  Watch watch(observer);
  std::vector<TableRequest> requests;
  for (const Entry entry : {Entry::rr, Entry::rphi, Entry::rtheta, Entry::phiphi, Entry::phitheta, Entry::thetatheta}) {
    requests.push_back({.entry = entry});
    requests.push_back({.entry = entry, .power = true});
  }
  requests.push_back({.entry = Entry::rr, .source_shape = 2});
  const int reach = c.phi_nodes / 3;
  const auto tables = OrderSum(c.sphere, c.angular_speed, mesh, 2, watch).tables(requests, reach, reach, 2, watch);
  const OrderSum full(c.sphere, c.angular_speed, mesh, one_by_one(octaves(c.phi_nodes), c.phi_nodes),
                      one_by_one(octaves(c.theta_nodes), c.theta_nodes), 2, watch);
  const auto expected = full.tables(requests, reach, reach, 2, watch);
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const bool power = requests[k].power;
    double center = 0.0;
    double error = 0.0;
    for (int j = -reach; j <= reach; ++j) {
      for (int l = 0; l <= reach; ++l) {
        center = std::max(center, std::abs(expected[power ? 1 : 0](j, l)));  // that of r by r
        error = std::max(error, std::abs(tables[k](j, l) - expected[k](j, l)));
      }
    }
    EXPECT_LT(error, 1e-9 * center) << "table " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Coatings, OctavesTest,
                         testing::Values(OctaveCase{"Measured", measured_sphere(), 2.5, 32, 32},
                                         OctaveCase{"Paper", cases::paper_sphere(), 2.5, 32, 32},
                                         OctaveCase{"UnlikeSpacings", cases::paper_sphere(), 2.5, 40, 24},
                                         OctaveCase{"LongMemory", cases::paper_sphere(), 200.0, 32, 32},
                                         OctaveCase{"ShortMemory", cases::paper_sphere(), 0.01, 32, 32},
                                         OctaveCase{"UnlikeLayers", cases::unlike_layers(), 2.5, 24, 24}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace viscoroll::detail
