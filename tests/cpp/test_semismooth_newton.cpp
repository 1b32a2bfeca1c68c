// The iteration that all contacts with friction share, on a system of one node.
#include <gtest/gtest.h>

#include "contact/semismooth_newton.hpp"

namespace viscoroll::detail {
namespace {

/// A pressed node that sticks once its traction has a certain value. The equations contain a wrong value until
/// displacements correct it, and each solve of the equations leaves a hundredth of the slip.
class LateCorrection : public StickSlipSystem {
 public:
  [[nodiscard]] ConditionScales scales() const override { return {.normal = 1.0, .tangential = 1.0}; }
  [[nodiscard]] double load() const override { return 1.0; }
  [[nodiscard]] Eigen::Index first_node() const override { return 0; }
  [[nodiscard]] double imbalance(const ContactSolution&) const override { return 0.0; }
  [[nodiscard]] int products() const override { return 0; }

  void find_displacements(ContactSolution& state) override {
    assumed_ = kTraction;
    state.slip(0, 0) = state.force(0, kForward) - kTraction;
    state.displacement = VectorField::Zero(1, 3);
  }

  void solve(double, const ContactSets&, double, ContactSolution& state) override {
    constexpr double kLeft = 0.01;
    const double traction = state.force(0, kForward);
    state.force.row(0) << assumed_ + kLeft * (traction - assumed_), -1.0, 0.0;
    state.slip(0, 0) = state.force(0, kForward) - assumed_;
    state.displacement.resize(0, 3);
  }

  static constexpr double kTraction = 0.1001;

 private:
  double assumed_ = 0.1;
};

TEST(SemismoothNewton, ComparesStepsOnlyWithStatesOfTheCorrectedEquations) {
  LateCorrection system;
  ContactSolution start{.force = VectorField::Zero(1, 3),
                        .displacement = {},
                        .gap = Eigen::ArrayXd::Zero(1),
                        .contact = {},
                        .slip = Eigen::ArrayX2d::Zero(1, 2)};
  // This force solves the equations before the correction.
  start.force.row(0) << 0.1, -1.0, 0.0;
  start.creepage = 0.0;
  SemismoothNewton newton(system, {.tolerance = 1e-12, .round_off = 1e-10, .full_steps = 1});
  newton.start_from(start);
  ASSERT_TRUE(newton.iterate(0.3));
  EXPECT_NEAR(newton.state().force(0, kForward), LateCorrection::kTraction, 1e-12);
  EXPECT_LE(newton.systems(), 6) << "each of them leaves a hundredth of 1e-4";
}

}  // namespace
}  // namespace viscoroll::detail
