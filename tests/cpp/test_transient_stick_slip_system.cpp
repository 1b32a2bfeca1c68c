// Stick and slip at one instant of a motion: the direct and the iterative solver find the same state, and the iterative
// solver can be canceled.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "cases.hpp"
#include "contact/semismooth_newton.hpp"
#include "contact/stick_slip_conditions.hpp"
#include "influence/table_sums.hpp"
#include "modal/layered_body.hpp"
#include "transient/stick_slip.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// A paraboloid is pressed on a coated surface and pushed forward along it. The given slip of each node is proportional
/// to its coordinates.
class TransientStickSlipTest : public testing::Test {
 protected:
  static constexpr Index kRows = 25;
  static constexpr Index kHalfNodes = 9;

  TransientStickSlipTest() {
    const Observer silent;
    Watch watch(silent);
    const Mesh mesh{.nodes_per_revolution = 200};
    const CoatingSum sum(layered_body(std::get<CoatedSphere>(with_relaxed_moduli(RollingBody(cases::paper_sphere())))),
                         1.0, mesh, 1, watch);
    tables_ = std::make_unique<const MirroredTables>(
        sum, RowShape{.components = 3, .half_nodes = kHalfNodes, .ring = 200, .most = 100}, 1, watch);
    const HalfField zero = HalfField::Zero(kHalfNodes, kRows);
    const HalfField one = HalfField::Ones(kHalfNodes, kRows);
    axes_[kForward] = {zero, one, zero};
    axes_[kDown] = {-one, zero, zero};
    axes_[kSideways] = {zero, zero, one};
    surface_ = std::make_unique<const StepOperator>(
        std::vector<StepOperator::Part>{{1.0, tables_.get(), &axes_, &axes_}}, [this] { checkpoint_(); });
    weights_ = half_weights(kHalfNodes).replicate(kRows, 1);
  }

  [[nodiscard]] StickSlipProblem problem() const {
    constexpr Index kSize = kRows * kHalfNodes;
    StickSlipProblem problem{.surface = *surface_,
                             .gap = ArrayXd(kSize),
                             .known_slip = Eigen::ArrayX2d::Zero(kSize, 2),
                             .slip_per_center_displacement = Eigen::ArrayX2d::Zero(kSize, 2),
                             .weights = weights_,
                             .load = 1.0,
                             .approach = {.value = 1.0},
                             .friction = 0.3,
                             .center_row = {},
                             .center_row_needs_displacements = false};
    const double instantaneous = surface_->diagonal_compliance();
    for (Index node = 0; node < kSize; ++node) {
      const Index row = node / kHalfNodes;
      const double x = static_cast<double>(row) - 12.0;
      const auto z = static_cast<double>(node % kHalfNodes);
      problem.gap[node] = weights_[node] * 2e-3 * instantaneous * (x * x + z * z);
      problem.known_slip.row(node) << weights_[node] * 1e-4 * instantaneous * x,
          weights_[node] * 2e-4 * instantaneous * z;
    }
    problem.slip_per_center_displacement.col(0) = weights_;
    CenterRow center{.force_coefficients = VectorField::Zero(kSize, 3), .displacement = 0.0, .value = 0.1};
    center.force_coefficients.col(kForward) = weights_;
    problem.center_row = [center](const std::vector<HalfField>&) { return center; };
    return problem;
  }

  /// Initial guess: equal pressures, also on nodes that are separated in the solution.
  [[nodiscard]] VectorField initial_guess() const {
    VectorField force = VectorField::Zero(kRows * kHalfNodes, 3);
    for (Index row = 1; row < 24; ++row) force.col(kDown).segment(row * kHalfNodes, 8).setConstant(-0.006);
    return force;
  }

  std::unique_ptr<const MirroredTables> tables_;
  Axes axes_;
  std::unique_ptr<const StepOperator> surface_;
  ArrayXd weights_;
  std::function<void()> checkpoint_ = [] {};
};

/// Result of the Newton iteration.
struct NewtonResult {
  ContactSolution state;
  ContactSets sets;
  bool converged;
};

/// Solve by Newton's method from a guess of the forces.
NewtonResult solve_from(StickSlipSystem& system, const VectorField& guess) {
  ContactSolution start;
  start.force = guess;
  start.gap = ArrayXd::Zero(guess.rows());
  start.slip = Eigen::ArrayX2d::Zero(guess.rows(), 2);
  start.creepage = 0.0;
  const ContactSets sets = find_sets(system, 0.3, start);
  SemismoothNewton newton(system, {.tolerance = 1e-12, .round_off = 1e-10, .full_steps = 8});
  newton.start_from(std::move(start));
  newton.take_step(0.3, sets, 1e-6);
  const bool converged = newton.iterate(0.3);
  return {newton.state(), newton.sets(), converged};
}

TEST_F(TransientStickSlipTest, DirectAndIterativeSolverFindTheSameState) {
  const StickSlipProblem problem = this->problem();
  ContactStiffness stiffness;
  const auto direct = direct_stick_slip(problem, initial_guess(), stiffness);
  const auto iterative = iterative_stick_slip(problem, initial_guess());
  const NewtonResult expected = solve_from(*direct, initial_guess());
  const NewtonResult found = solve_from(*iterative, initial_guess());
  ASSERT_TRUE(expected.converged);
  ASSERT_TRUE(found.converged);
  ASSERT_EQ(found.sets.contact, expected.sets.contact);
  std::size_t sticking = 0;
  for (std::size_t i = 0; i < found.sets.contact.size(); ++i) {
    EXPECT_EQ(found.sets.states[i].stick, expected.sets.states[i].stick);
    sticking += found.sets.states[i].stick ? 1 : 0;
  }
  EXPECT_GT(sticking, 5U);
  EXPECT_LT(sticking + 5, found.sets.contact.size());
  const double largest_force = expected.state.force.col(kDown).abs().maxCoeff();
  EXPECT_LT((found.state.force - expected.state.force).abs().maxCoeff(), 1e-9 * largest_force);
  EXPECT_NEAR(found.state.penetration, expected.state.penetration, 1e-9 * expected.state.penetration);
  EXPECT_NEAR(*found.state.creepage, *expected.state.creepage, 1e-9 * std::abs(*expected.state.creepage));
}

TEST_F(TransientStickSlipTest, SpringAndGivenPenetrationFindTheStateOfTheirLoad) {
  ContactStiffness stiffness;
  StickSlipProblem problem = this->problem();
  const ContactSolution expected =
      solve_from(*direct_stick_slip(problem, initial_guess(), stiffness), initial_guess()).state;
  const double penetration = expected.penetration;
  const double spring = 3.0 / penetration;
  const VectorField nearby = 1.05 * expected.force;
  const std::array conditions{
      ApproachCondition{.force = 1.0, .penetration = spring, .value = 1.0 + spring * penetration},
      ApproachCondition{.force = 1.0, .penetration = 1e6 * spring, .value = 1.0 + 1e6 * spring * penetration},
      ApproachCondition{.force = 0.0, .penetration = 1.0, .value = penetration}};
  for (const ApproachCondition& condition : conditions) {
    problem.approach = condition;
    const auto direct = direct_stick_slip(problem, nearby, stiffness);
    const auto iterative = iterative_stick_slip(problem, nearby);
    for (StickSlipSystem* system : {direct.get(), iterative.get()}) {
      const NewtonResult found = solve_from(*system, nearby);
      ASSERT_TRUE(found.converged);
      EXPECT_NEAR(found.state.penetration, penetration, 1e-9 * penetration);
      EXPECT_LT((found.state.force - expected.force).abs().maxCoeff(), 1e-8 * expected.force.abs().maxCoeff());
      EXPECT_NEAR(*found.state.creepage, *expected.creepage, 1e-8 * std::abs(*expected.creepage));
    }
  }
}

TEST_F(TransientStickSlipTest, IterativeSolverCanBeCanceled) {
  int calls = 0;
  checkpoint_ = [&] {
    if (++calls == 7) throw std::runtime_error("canceled");
  };
  const StickSlipProblem problem = this->problem();
  const auto iterative = iterative_stick_slip(problem, initial_guess());
  EXPECT_THROW(solve_from(*iterative, initial_guess()), std::runtime_error);
  EXPECT_EQ(calls, 7);
}

}  // namespace
}  // namespace viscoroll::detail
