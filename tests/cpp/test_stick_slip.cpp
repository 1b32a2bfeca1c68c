#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "cases.hpp"
#include "contact/stick_slip_by_products.hpp"
#include "dense_oracle.hpp"
#include "influence/table_sums.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {
namespace {

enum class DriveKind { force, torque, creepage, oblique };

/// A contact of 121 nodes, whose front sticks and whose rear slips, with forces that are not in equilibrium.
class StickSlipTest : public testing::TestWithParam<std::tuple<Compliance, PatchLoad, DriveKind, Deforming>> {
 protected:
  StickSlipTest() {
    const CoatingSum orders(layered_body(cases::paper_sphere()), 2.5, mesh_, 2, watch_);
    surface_ = std::make_shared<TableOperator>(
        formulation_, nodes_.grid(), nodes_.window(),
        std::make_shared<const std::vector<Table>>(orders.tables(displacement_tables(formulation_), 16, 16, 2, watch_)),
        nullptr, execution_);
    const WindowShape shape = nodes_.shape();
    state_.force = VectorField::Zero(shape.size(), 3);
    for (Eigen::Index i = 3; i < shape.phi_nodes - 2; ++i) {
      for (Eigen::Index k = 2; k < shape.theta_nodes - 2; ++k) {
        if (std::hypot(static_cast<double>(i - 8), static_cast<double>(k - 8)) > 6.0) continue;
        const Eigen::Index node = i * shape.theta_nodes + k;
        const auto aside = static_cast<double>(k - 8);
        const double angle = aside * (0.1 + 0.02 * static_cast<double>(i));
        // Rows of sticking nodes have gaps, symmetric about the middle.
        const bool stick = i < 9 && (i + 2 * std::abs(k - 8)) % 11 != 0;
        sets_.contact.push_back(node);
        sets_.states.push_back({.stick = stick,
                                .direction = {stick ? 1.0 : std::cos(angle), stick ? 0.0 : std::sin(angle)},
                                .rigidity = stick ? 1.0 : 0.6 - 0.02 * std::abs(aside)});
        state_.force.row(node) << 0.1, -1.0 + 0.02 * std::abs(aside), 0.05 * aside;
      }
    }
    find_displacements(*surface_, state_);
    state_.penetration = 1e-4;
    state_.creepage = 0.02;
  }

  [[nodiscard]] std::shared_ptr<const DriveCondition> drive() const {
    switch (std::get<DriveKind>(GetParam())) {
      case DriveKind::force:
        return std::make_shared<GivenForce>(5.0);
      case DriveKind::torque:
        return std::make_shared<GivenMoment>(0.1, formulation_.compliance == Compliance::vertical ? 1.0 : 0.0);
      default:
        return std::make_shared<GivenCreepage>(0.01);
    }
  }

  [[nodiscard]] ContactProblem problem() const {
    const double step = 21e-3 * phi_spacing(mesh_);
    Eigen::ArrayX2d rigid_slip = Eigen::ArrayX2d::Constant(nodes_.shape().size(), 2, 0.0);
    rigid_slip.col(0).setConstant(-0.01 * step);
    if (std::get<DriveKind>(GetParam()) == DriveKind::oblique) rigid_slip.col(1).setConstant(0.02 * step);
    Eigen::ArrayX2d counterbody_rigid_displacement = Eigen::ArrayX2d::Zero(nodes_.shape().size(), 2);
    counterbody_rigid_displacement.col(0) = step * (1.0 - 10.0 * nodes_.z().abs());
    return {.surface = surface_,
            .initial_gap = nodes_.height(),
            .normal_force = 100.0,
            .friction =
                Friction{.coefficient = 0.3,
                         .rigid_slip = std::move(rigid_slip),
                         .counterbody_rigid_displacement = std::move(counterbody_rigid_displacement),
                         .step = step,
                         .arms = {.x = nodes_.x(), .y = nodes_.points().y().values(), .radius = nodes_.grid().radius},
                         .drive = drive()}};
  }

  Formulation formulation_{.compliance = std::get<Compliance>(GetParam()),
                           .patch_load = std::get<PatchLoad>(GetParam()),
                           .tangential = true,
                           .is_counterbody = std::get<Deforming>(GetParam()) == Deforming::counterbody};
  Mesh mesh_{.nodes_per_revolution = 300};
  SurfaceWindow nodes_{{21e-3, phi_spacing(mesh_), theta_spacing(mesh_)}, {{-8, 8}, {-8, 8}}};
  std::shared_ptr<const SurfaceOperator> surface_;
  ContactSets sets_;
  ContactSolution state_;
  Observer observer_;
  Watch watch_{observer_};
  Execution execution_{2, watch_};
};

TEST_P(StickSlipTest, IterativeStepAgreesWithADenseSolution) {
  const ContactProblem problem = this->problem();
  StickSlipByProducts system(problem);
  const Eigen::VectorXd dense =
      oracle::newton_step(problem, oracle::compliance(*surface_), system.scales(), sets_, state_);
  ContactSolution iterated = state_;
  system.solve(0.3, sets_, 1e-13, iterated);
  const Eigen::Index forces = 3 * nodes_.shape().size();
  const Eigen::VectorXd force = iterated.force.matrix().reshaped();
  EXPECT_LT((force - dense.head(forces)).cwiseAbs().maxCoeff(), 1e-8 * force.cwiseAbs().maxCoeff());
  EXPECT_NEAR(iterated.penetration, dense[forces], 1e-8 * std::abs(dense[forces]));
  EXPECT_NEAR(*iterated.creepage, dense[forces + 1], 1e-8);
}

/// Compare with differences of antiderivatives in long doubles, because small windows lose the last digits.
TEST(SurfaceWindow, LagIsTheIntegralOfItsHeight) {
  constexpr double kRadius = 0.5;
  for (const double spacing : {1e-5, 0.03}) {
    for (const bool is_paraboloid : {false, true}) {
      const SurfaceGrid grid{
          .radius = kRadius, .phi_spacing = spacing, .theta_spacing = 0.7 * spacing, .is_paraboloid = is_paraboloid};
      const SurfaceWindow points(grid, {{-5, 4}, {-3, 3}}, 0.3);
      const Eigen::ArrayXd lag = points.lag();
      EXPECT_EQ(lag.head(7).abs().maxCoeff(), 0.0);
      for (Eigen::Index node = 7; node < lag.size(); ++node) {
        const Eigen::Index i = node / 7 - 5;
        const Eigen::Index k = node % 7 - 3;
        const auto row = static_cast<long double>(i) + 0.3L;
        const auto column = static_cast<long double>(k);
        const long double theta = 0.7L * spacing * column;
        const auto to_here = [&](long double phi) {
          return is_paraboloid ? phi * phi * phi / 6.0L + 0.5L * theta * theta * phi
                               : phi - std::cos(theta) * std::sin(phi);
        };
        const long double expected = kRadius * (to_here(row * spacing) - to_here((row - 1.0L) * spacing));
        EXPECT_NEAR(lag[node], static_cast<double>(expected), 1e-15 * kRadius * spacing) << node;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formulations, StickSlipTest,
                         testing::Combine(testing::Values(Compliance::vertical, Compliance::radial),
                                          testing::Values(PatchLoad::flat, PatchLoad::spherical),
                                          testing::Values(DriveKind::force, DriveKind::torque, DriveKind::creepage,
                                                          DriveKind::oblique),
                                          testing::Values(Deforming::rolling)));

INSTANTIATE_TEST_SUITE_P(Counterbodies, StickSlipTest,
                         testing::Combine(testing::Values(Compliance::radial), testing::Values(PatchLoad::flat),
                                          testing::Values(DriveKind::force, DriveKind::torque, DriveKind::creepage,
                                                          DriveKind::oblique),
                                          testing::Values(Deforming::counterbody)));

}  // namespace
}  // namespace viscoroll::detail
