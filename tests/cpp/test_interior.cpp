#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/interior.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll {
namespace {

struct Rolling {
  CoatedSphere sphere;
  LoadCase load_case{.load = 100.0, .angular_speed = 2.5};
  Options options{.mesh = Mesh{.nodes_per_revolution = 200}};
  Result result = solve(sphere, load_case, options);
  Tractions tractions = tractions_of(sphere, result, load_case, options);

  explicit Rolling(CoatedSphere body) : sphere(std::move(body)) {}

  [[nodiscard]] InteriorFields fields(int threads) const {
    const std::vector<double> radii{21e-3 - 0.3e-3, 20e-3};
    const std::vector<double> angles{0.5 * std::numbers::pi, 0.5 * std::numbers::pi + 0.03, 1.5};
    const auto places = places_at(sphere, radii);
    return interior_fields(sphere, load_case.angular_speed, tractions, places, angles, angles, std::nullopt, threads);
  }
};

TEST(Interior, StatesAtTheSurfaceAgreeWithTheCompliance) {
  const detail::HarmonicBody coating(detail::layered_body(cases::dissimilar_layers(1000.0)), 20.0, {0.0, 3.0, 40.0});
  for (std::size_t i = 0; i < coating.orders().size(); ++i) {
    const auto layers = coating.layers_at(i);
    for (const double n : {-7.0, 0.0, 12.5}) {
      const detail::OrderInLayers<std::complex<double>> order{.layers = layers, .m = coating.orders()[i], .n = n};
      std::vector<detail::DepthState> states;
      detail::depth_states(std::span(&order, 1), std::span(&states, 1));
      const auto compliance = detail::surface_compliance(layers, order.m, n);
      ASSERT_EQ(states.size(), layers.media.size() + 1);
      const Eigen::Matrix3cd displacement = states.back().topRows<3>() * coating.radius();
      EXPECT_LT((displacement - compliance).cwiseAbs().maxCoeff(), 1e-12 * compliance.cwiseAbs().maxCoeff());
      EXPECT_LT((states.back().bottomRows<3>() - Eigen::Matrix3cd::Identity()).cwiseAbs().maxCoeff(), 1e-15);
    }
  }
}

TEST(Interior, FieldsExistOnBothSidesOfABoundary) {
  const CoatedSphere sphere = cases::dissimilar_layers();
  const std::vector<double> radii{22e-3, 20e-3, 22.5e-3};
  const auto places = places_at(sphere, radii);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(places[0].layer, 1);
  EXPECT_EQ(places[1].layer, 0);
  EXPECT_EQ(places[2].layer, 0);
  EXPECT_EQ(places[3].layer, 1);
  const std::vector<double> outside{19e-3};
  EXPECT_THROW((void)places_at(sphere, outside), std::invalid_argument);
}

TEST(Interior, FieldsAndLossDoNotDependOnThreads) {
  const Rolling rolling(cases::paper_sphere());
  EXPECT_EQ(rolling.fields(1).values, rolling.fields(3).values);
  const auto loss = [&](int threads) { return loss_density(rolling.sphere, 2.5, rolling.tractions, {}, 60, threads); };
  EXPECT_EQ(loss(1).density, loss(3).density);
  EXPECT_EQ(loss(1).volume_power, loss(3).volume_power);
}

TEST(Interior, LossInTheVolumeEqualsThePowerAtTheSurface) {
  const Rolling rolling(cases::dissimilar_layers(1000.0));
  const LossDensity loss = loss_density(rolling.sphere, 2.5, rolling.tractions, {}, 120);
  // Errors of the radial nodes of the volume integral, and of the series of the fields.
  EXPECT_NEAR(loss.volume_power / loss.surface_power, 1.0, 1e-9);
  double sum = 0.0;
  for (std::size_t place = 0; place < loss.places.size(); ++place) {
    for (std::size_t j = 0; j < loss.theta.size(); ++j) {
      const double radius = loss.places[place].position;
      sum += loss.weights[place] * radius * radius * loss.density[place * loss.theta.size() + j];
    }
  }
  const double spacing = 2.0 * std::numbers::pi / static_cast<double>(loss.theta.size());
  EXPECT_NEAR(2.5 * spacing * sum / loss.volume_power, 1.0, 1e-12);
}

TEST(Interior, ColumnsOfAWheelHaveTheirOwnSpacing) {
  const CoatedWheel wheel{.core_radius = 40e-3,
                          .layers = {{.thickness = 10e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.45}},
                          .width = 30e-3,
                          .crown_radius = 0.2,
                          .sides = Sides::unbounded};
  const LoadCase load_case{.load = 100.0, .angular_speed = 2.5};
  const Options options{.mesh = Mesh{.nodes_per_revolution = 200}};
  const Result result = solve(wheel, load_case, options);
  const Tractions tractions = tractions_of(wheel, result, load_case, options);
  ASSERT_TRUE(tractions.theta_spacing);
  const double columns = wheel.width / (*tractions.theta_spacing * tractions.radius);
  EXPECT_NEAR(columns, std::round(columns), 1e-9);
  EXPECT_GT(std::abs(*tractions.theta_spacing - theta_spacing(result.mesh)), 1e-3 * *tractions.theta_spacing);
  const LossDensity loss = loss_density(wheel, 2.5, tractions, {}, 200);
  EXPECT_NEAR(loss.volume_power / loss.surface_power, 1.0, 1e-8);
  // With the patches of the mesh in place of the wheel's own, the sum of the tractions would be another load.
  Tractions of_mesh = tractions;
  of_mesh.theta_spacing.reset();
  EXPECT_GT(std::abs(loss_density(wheel, 2.5, of_mesh, {}, 200).surface_power / loss.surface_power - 1.0), 1e-3);
}

TEST(Interior, CanBeStopped) {
  const Rolling rolling(cases::paper_sphere());
  const Observer stop{.cancelled = [] { return true; }, .progress = {}};
  EXPECT_THROW((void)loss_density(rolling.sphere, 2.5, rolling.tractions, {}, 2000, 1, stop), Canceled);
}

TEST(Interior, RejectsBadTractions) {
  const Rolling rolling(cases::paper_sphere());
  Tractions few = rolling.tractions;
  few.pressure.pop_back();
  EXPECT_THROW((void)loss_density(rolling.sphere, 2.5, few, {}, 10), std::invalid_argument);
  Tractions even = rolling.tractions;
  even.phi_nodes -= 1;
  EXPECT_THROW((void)loss_density(rolling.sphere, 2.5, even, {}, 10), std::invalid_argument);
  Tractions exact = rolling.tractions;
  exact.curvature = Curvature::exact;
  EXPECT_THROW((void)loss_density(rolling.sphere, 2.5, exact, {}, 10), std::invalid_argument);
}

}  // namespace
}  // namespace viscoroll
