#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "cases.hpp"
#include "contact/stick_slip_products.hpp"
#include "contact/stick_slip_system.hpp"
#include "contact/surface_window.hpp"
#include "influence/synthesis.hpp"

namespace viscoroll::detail {
namespace {

/// A contact of 121 nodes of which those in front stick and those behind slip, with forces that solve nothing yet.
class StickSlipTest : public testing::TestWithParam<std::tuple<Compliance, PatchLoad, Drive>> {
 protected:
  StickSlipTest() {
    const OrderSum orders(cases::paper_sphere(), 2.5, mesh_, 2, watch_);
    tables_ =
        std::make_shared<const std::vector<Table>>(orders.tables(displacement_tables(formulation_), 16, 16, 2, watch_));
    coating_ = std::make_unique<CoatingCompliance>(formulation_, window_, tables_, execution_);
    const WindowShape shape = window_.shape();
    state_.force = VectorField::Zero(shape.size(), 3);
    for (Eigen::Index i = 3; i < shape.phi_nodes - 2; ++i) {
      for (Eigen::Index k = 2; k < shape.theta_nodes - 2; ++k) {
        if (std::hypot(static_cast<double>(i - 8), static_cast<double>(k - 8)) > 6.0) continue;
        const Eigen::Index node = i * shape.theta_nodes + k;
        const auto aside = static_cast<double>(k - 8);
        const double angle = aside * (0.1 + 0.02 * static_cast<double>(i));
        // Holes in the runs of sticking nodes, too; mirror images alike.
        const bool stick = i < 9 && (i + 2 * std::abs(k - 8)) % 11 != 0;
        sets_.contact.push_back(node);
        sets_.states.push_back({.stick = stick,
                                .direction = {stick ? 1.0 : std::cos(angle), stick ? 0.0 : std::sin(angle)},
                                .rigidity = stick ? 1.0 : 0.6 - 0.02 * std::abs(aside)});
        state_.force.row(node) << 0.1, -1.0 + 0.02 * std::abs(aside), 0.05 * aside;
      }
    }
    state_.displacement = coating_->displacement(state_.force);
    state_.penetration = 1e-4;
    state_.speed_ratio = 1.0;
  }

  [[nodiscard]] FrictionalContactProblem problem() const {
    const double step = 21e-3 * phi_spacing(mesh_);
    return {.normal = {.coating = *coating_, .drop = window_.height(), .load = 100.0},
            .shape = window_.shape(),
            .x = window_.x(),
            .y = window_.y(),
            .ways = Eigen::ArrayXd::Constant(window_.shape().size(), -1.01 * step),
            .step = step,
            .friction = 0.3,
            .drive = std::get<Drive>(GetParam()),
            .lever_arm = formulation_.compliance == Compliance::vertical ? LeverArm::displaced : LeverArm::undisplaced};
  }

  Formulation formulation_{std::get<Compliance>(GetParam()), std::get<PatchLoad>(GetParam()), true};
  Mesh mesh_{.nodes_per_revolution = 300};
  SurfaceWindow window_{{21e-3, phi_spacing(mesh_), theta_spacing(mesh_)}, {-8, 8}, {-8, 8}};
  std::shared_ptr<const std::vector<Table>> tables_;
  std::unique_ptr<CoatingCompliance> coating_;
  ContactSets sets_;
  ContactSolution state_;
  Observer observer_;
  Watch watch_{observer_};
  Execution execution_{2, watch_};
};

TEST_P(StickSlipTest, ProductsTakeTheStepOfElimination) {
  const FrictionalContactProblem problem = this->problem();
  const ConditionScales scales = condition_scales(problem);
  ContactSolution eliminated = state_;
  take_newton_step(problem, 0.3, scales, sets_, {.max_iterations = 1, .max_unknowns = 10000}, eliminated);
  ContactSolution iterated = state_;
  take_newton_step_by_products(problem, 0.3, scales, sets_, StickSlipPreconditioner(*coating_), 1e-12, iterated);
  const double largest = eliminated.force.abs().maxCoeff();
  EXPECT_LT((iterated.force - eliminated.force).abs().maxCoeff(), 1e-8 * largest);
  EXPECT_NEAR(iterated.penetration, eliminated.penetration, 1e-8 * std::abs(eliminated.penetration));
  EXPECT_NEAR(*iterated.speed_ratio, *eliminated.speed_ratio, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(
    Formulations, StickSlipTest,
    testing::Combine(testing::Values(Compliance::vertical, Compliance::radial),
                     testing::Values(PatchLoad::flat, PatchLoad::spherical),
                     testing::Values(Drive(DriveForce{.force = 5.0}), Drive(DriveTorque{.torque = 0.1}),
                                     Drive(DriveCreepage{.creepage = 0.01}),
                                     Drive(DriveCreepage{.creepage = 0.01, .lateral_creepage = 0.02}))));

}  // namespace
}  // namespace viscoroll::detail
