#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "contact/active_set.hpp"
#include "contact/contact_extent.hpp"
#include "contact/flat_equations.hpp"
#include "contact/krylov.hpp"
#include "contact/multilevel.hpp"
#include "contact/normal_contact.hpp"
#include "contact/transfer.hpp"
#include "dense_oracle.hpp"
#include "influence/table_sums.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {
namespace {

CoatedSphere elastic_sphere() {
  return {.core_radius = 20e-3, .layers = {{.thickness = 3e-3, .shear_modulus = Elastic{2e6}, .poisson_ratio = 0.45}}};
}

/// Sphere, mesh and surface operator.
struct Model {
  Model(const CoatedSphere& sphere, Formulation formulation, const Window& window, int nodes_per_revolution = 160)
      : mesh{.nodes_per_revolution = nodes_per_revolution, .max_order = nodes_per_revolution},
        orders(layered_body(sphere), 2.5, mesh, 2, watch),
        nodes({outer_radius(sphere), phi_spacing(mesh), theta_spacing(mesh)}, window) {
    const auto tables = [this](const std::vector<TableRequest>& requests, int phi_reach, int theta_reach) {
      return std::make_shared<const std::vector<Table>>(orders.tables(requests, phi_reach, theta_reach, 2, watch));
    };
    const WindowShape shape = window.shape();
    surface = std::make_shared<TableOperator>(
        formulation, nodes.grid(), nodes.window(),
        tables(displacement_tables(formulation), shape.phi_nodes - 1, shape.theta_nodes - 1),
        [tables, formulation](int phi_reach, int theta_reach) {
          return tables(dissipation_tables(formulation), phi_reach, theta_reach);
        },
        Execution{2, watch});
  }

  [[nodiscard]] ContactProblem problem(double normal_force) const {
    return {.surface = surface, .initial_gap = nodes.height(), .normal_force = normal_force, .friction = std::nullopt};
  }

  Observer observer;
  Watch watch{observer};
  Mesh mesh;
  CoatingSum orders;
  SurfaceWindow nodes;
  std::shared_ptr<const SurfaceOperator> surface;
};

class NormalContactTest : public testing::TestWithParam<std::tuple<bool, Compliance, PatchLoad>> {};

TEST_P(NormalContactTest, AgreesWithADenseSolution) {
  const auto& [lossless, compliance, patch_load] = GetParam();
  const Model model(lossless ? elastic_sphere() : cases::dissimilar_layers(),
                    {.compliance = compliance, .patch_load = patch_load, .tangential = false}, {{-10, 10}, {-9, 9}});
  const ContactProblem problem = model.problem(60.0);
  const NormalContactGuess guess{.contact = {model.nodes.window().number_of(0, 0)},
                                 .pressing = Eigen::ArrayXd::Zero(Eigen::Index{21} * 19),
                                 .penetration = 0.0};
  const ContactSolution contact = solve_normal_contact(problem, guess, {.max_iterations = 100});
  EXPECT_TRUE(contact.converged);
  EXPECT_GT(contact.contact.size(), 40);
  const Eigen::VectorXd dense = oracle::press_flat(problem, oracle::compliance(*model.surface, false), contact.contact);
  const auto count = static_cast<Eigen::Index>(contact.contact.size());
  const Eigen::VectorXd pressing = pressing_force(contact)(contact.contact).matrix();
  EXPECT_LT((pressing - dense.head(count)).cwiseAbs().maxCoeff(), 1e-9 * dense.head(count).maxCoeff());
  EXPECT_NEAR(contact.penetration, dense[count], 1e-9 * dense[count]);
  EXPECT_GE(contact.gap.minCoeff(), -1e-9 * contact.penetration);

  // The iterative solver finds the same forces as the dense solution.
  NormalContactGuess same{.contact = contact.contact,
                          .pressing = Eigen::ArrayXd::Zero(guess.pressing.size()),
                          .penetration = contact.penetration};
  same.pressing(same.contact).setConstant(60.0 / static_cast<double>(count));
  const Eigen::ArrayXd by_products = pressing_force(solve_given_nodes(problem, same, {.max_iterations = 1}));
  EXPECT_LT((by_products - pressing_force(contact)).abs().maxCoeff(), 1e-9 * dense.head(count).maxCoeff());

  // At the given penetration, both solvers find the load. Without the load's row, C p = d - gap determines the forces.
  ContactProblem lowered = problem;
  lowered.penetration = 1.1 * contact.penetration;
  const ContactSolution deeper = solve_normal_contact(lowered, guess, {.max_iterations = 100});
  EXPECT_TRUE(deeper.converged);
  EXPECT_EQ(deeper.penetration, *lowered.penetration);
  EXPECT_GE(deeper.gap.minCoeff(), -1e-9 * deeper.penetration);
  const auto nodes = static_cast<Eigen::Index>(problem.initial_gap.size());
  const Eigen::MatrixXd matrix =
      oracle::compliance(*model.surface, false).block(nodes, nodes, nodes, nodes)(deeper.contact, deeper.contact);
  const Eigen::VectorXd forces =
      dense_inverse(matrix) * (*lowered.penetration - problem.initial_gap(deeper.contact)).matrix();
  const Eigen::ArrayXd found = pressing_force(deeper);
  EXPECT_LT((found(deeper.contact).matrix() - forces).cwiseAbs().maxCoeff(), 1e-9 * forces.maxCoeff());
  NormalContactGuess far{.contact = deeper.contact, .pressing = 0.5 * found, .penetration = 0.0};
  const Eigen::ArrayXd iterated = pressing_force(solve_given_nodes(lowered, far, {.max_iterations = 1}));
  EXPECT_LT((iterated - found).abs().maxCoeff(), 1e-9 * forces.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Formulations, NormalContactTest,
                         testing::Combine(testing::Bool(), testing::Values(Compliance::vertical, Compliance::radial),
                                          testing::Values(PatchLoad::flat, PatchLoad::spherical)));

/// Contact of a row of nodes under Hertz's pressure, whose half-width is a number of spacings.
ContactExtent row_under_hertz(double half_width, double center, double left_out = 1e9) {
  constexpr double kRadius = 1000.0;  // the row is nearly straight
  const SurfaceWindow nodes({kRadius, 1.0 / kRadius, 1.0 / kRadius}, {{-40, 40}, {0, 0}});
  std::vector<Eigen::Index> contact;
  std::vector<double> pressure;
  for (int node = -40; node <= 40; ++node) {
    const double t = (node - center) / half_width;
    if (std::abs(t) >= 1.0 || node == left_out) continue;
    contact.push_back(node + 40);
    pressure.push_back(std::sqrt(1.0 - t * t));
  }
  const Eigen::ArrayXd pressures = Eigen::Map<const Eigen::ArrayXd>(pressure.data(), std::ssize(pressure));
  return contact_extent(nodes, contact, Eigen::ArrayXd::Ones(pressures.size()), pressures);
}

TEST(ContactExtent, FindsTheEdgesOfHertzsPressureBetweenTheNodes) {
  for (const double half_width : {20.0, 20.3, 20.6, 20.99}) {
    for (const double center : {0.0, 0.4, -3.7}) {
      // The squared pressure is a parabola. Positions on the circle deviate from the row by 1e-4 spacings.
      EXPECT_NEAR(row_under_hertz(half_width, center).contact_length, 2.0 * half_width, 2e-3 * half_width);
    }
  }
}

TEST(ContactExtent, EndsAtTheSidesOfPatchesWhereTheEdgeCannotBeExtrapolated) {
  EXPECT_NEAR(row_under_hertz(2.5, 0.0).contact_length, 5.0, 1e-4);  // five nodes are too few
  // The nodes beyond a node out of contact do not help to find the edge.
  EXPECT_NEAR(row_under_hertz(20.2, 0.0, 17.0).contact_length, 40.2 + 0.5, 0.02);
  const SurfaceWindow nodes({1.0, 1e-3, 1e-3}, {{-2, 2}, {-2, 2}});
  const ContactExtent none = contact_extent(nodes, {}, Eigen::ArrayXd(), Eigen::ArrayXd());
  EXPECT_EQ(none.contact_length, 0.0);
  EXPECT_EQ(none.max_pressure, 0.0);
  // A jump of the pressure lies half a spacing beyond the last node on average.
  const SurfaceWindow row({1000.0, 1e-3, 1e-3}, {{-10, 10}, {0, 0}});
  std::vector<Eigen::Index> contact(15);
  std::iota(contact.begin(), contact.end(), 3);
  EXPECT_NEAR(contact_extent(row, contact, Eigen::ArrayXd::Ones(15), Eigen::ArrayXd::Ones(15)).contact_length, 15.0,
              1e-3);
}

/// The multilevel solver cannot enlarge a box around a contact beyond the end of its window.
TEST(MultilevelContact, ReachesTheEdgeOfItsWindow) {
  const Model model(elastic_sphere(), {.compliance = Compliance::radial, .tangential = false}, {{-40, 40}, {-40, 40}},
                    600);
  ContactProblem problem = model.problem(20.0);
  const Eigen::ArrayXd x = model.nodes.x();
  // The tilt moves the lowest point to an edge of the window.
  problem.initial_gap += x.maxCoeff() / 23e-3 * x;
  const LocatedContact located = solve_multilevel(problem, 1e-5, {.max_iterations = 100});
  EXPECT_TRUE(touches_edge(located, located.window()));
  EXPECT_NE(located.window(), model.nodes.window());
}

class CoarserSelfTest : public testing::TestWithParam<std::tuple<bool, double>> {};

/// A coarse node represents the fine nodes whose patches form its patch. If displacements are evaluated downstream of
/// the nodes, its displacement is the mean of two fine ones.
TEST_P(CoarserSelfTest, RepresentsTheFineSurface) {
  const auto& [tangential, collocation] = GetParam();
  const Model model(cases::dissimilar_layers(), {Compliance::radial, PatchLoad::flat, tangential, collocation},
                    {{-9, 11}, {-10, 10}});
  LocatedContact coarse{.problem = coarsened(model.problem(1.0)), .contact = {}};
  const Window& window = coarse.window();
  VectorField force = VectorField::Zero(window.shape().size(), 3);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!tangential && axis != kDown) continue;
    force.col(axis) = Eigen::ArrayXd::LinSpaced(force.rows(), 1.0, 9.0 + static_cast<double>(axis)).sin();
  }
  coarse.contact.force = force;
  const VectorField fine_force = prolonged_force(coarse, model.nodes.window());
  const VectorField moved = coarse.problem.surface->displacement(force);
  const VectorField fine_moved = model.surface->displacement(fine_force);
  // Tangential forces contribute to the normal force by x/r, which is not constant over a coarse patch.
  const double tolerance = tangential ? 1e-2 : 1e-12;
  const double largest = moved.abs().maxCoeff();
  for (int i = window.phi.first; i <= window.phi.last; ++i) {
    for (int k = window.theta.first; k <= window.theta.last; ++k) {
      const Eigen::Index fine = model.nodes.window().number_of(2 * i, 2 * k);
      const Eigen::Array3d expected = (1.0 - collocation) * fine_moved.row(fine) +
                                      collocation * fine_moved.row(fine + model.nodes.shape().theta_nodes);
      const Eigen::Array3d difference = moved.row(window.number_of(i, k)).transpose() - expected;
      EXPECT_LT(difference.abs().maxCoeff(), tolerance * largest) << i << " " << k;
    }
  }
  const double lost = model.surface->dissipation(fine_force).rolling;
  EXPECT_NEAR(coarse.problem.surface->dissipation(force).rolling, lost, std::max(tolerance, 1e-10) * lost);
}

INSTANTIATE_TEST_SUITE_P(Collocations, CoarserSelfTest, testing::Combine(testing::Bool(), testing::Values(0.0, 0.25)));

TEST(SurfaceOperator, ScalesDoNotDependOnTheWindow) {
  // In a box with an even number of rows, the middle of the list of nodes is not the lowest node.
  const Formulation formulation{Compliance::radial, PatchLoad::flat, true};
  const Model model(cases::paper_sphere(), formulation, {{-12, 12}, {-9, 9}});
  for (const Window& box : {Window{{-7, 6}, {-5, 5}}, Window{{-12, 3}, {-9, 9}}}) {
    const auto part = model.surface->within(box);
    EXPECT_EQ(part->normal_stiffness(), model.surface->normal_stiffness());
    EXPECT_EQ(part->slip_stiffness(), model.surface->slip_stiffness());
  }
  const Eigen::MatrixXd matrix = oracle::compliance(*model.surface);
  const Eigen::Index lowest = model.nodes.window().number_of(0, 0);
  const Eigen::Index nodes = model.nodes.shape().size();
  EXPECT_NEAR(model.surface->normal_stiffness() * matrix(nodes + lowest, nodes + lowest), 1.0, 1e-12);
  EXPECT_NEAR(model.surface->slip_stiffness() * (matrix(lowest, lowest) - matrix(lowest - 19, lowest)), 1.0,
              1e-2);  // the difference is u_r x/r
}

TEST(FlatEquations, ResidualOfAStateFollowsFromItsGap) {
  const Model model(cases::dissimilar_layers(),
                    {.compliance = Compliance::vertical, .patch_load = PatchLoad::flat, .tangential = false},
                    {{-10, 10}, {-9, 9}});
  ContactProblem problem = model.problem(60.0);
  const InverseConvolution inverse = normal_inverse(*model.surface);
  const double stiffness = model.surface->normal_stiffness();
  constexpr double kPenetration = 2e-4;
  Eigen::ArrayXd pressing = Eigen::ArrayXd::Zero(problem.initial_gap.size());
  std::vector<Eigen::Index> nodes;
  for (int i = -4; i <= 3; ++i) {
    for (int k = -3; k <= 3; ++k) {
      nodes.push_back(model.nodes.window().number_of(i, k));
      pressing[nodes.back()] = 2.0 - 0.1 * i - 0.1 * k * k;
    }
  }
  for (const std::optional<double> given : {std::optional<double>(), std::optional(kPenetration)}) {
    problem.penetration = given;
    for (const bool mirrored : {false, true}) {
      const FlatEquations equations(problem, inverse, nodes, mirrored, stiffness);
      const Eigen::VectorXd unknowns = equations.unknowns(pressing, kPenetration);
      const Eigen::ArrayXd gap =
          problem.initial_gap + model.surface->normal_displacement(pressing, mirrored) - kPenetration;
      const Eigen::VectorXd expected = equations.right_side() - equations.times(unknowns);
      EXPECT_GT(expected.norm(), 1.0);
      EXPECT_LT((equations.residual(unknowns, gap) - expected).norm(), 1e-12 * equations.right_side().norm());
      // Krylov solutions from a known residual are those from an unknown one.
      const auto solve = [&](std::optional<Eigen::VectorXd> residual) {
        return solve_krylov([&](const Eigen::VectorXd& v) { return equations.times(v); },
                            [&](const Eigen::VectorXd& v) { return equations.precondition(v); }, equations.right_side(),
                            unknowns, {.absolute = 1e-11}, std::move(residual));
      };
      const KrylovSolution computed = solve(std::nullopt);
      const KrylovSolution known = solve(expected);
      EXPECT_EQ(known.products, computed.products - 1);
      EXPECT_LT((known.unknowns - computed.unknowns).norm(), 1e-12 * computed.unknowns.norm());
    }
  }
}

/// Three nodes, of which the last one has neither a force nor a gap, except for errors of the linear systems.
class UndecidedSurface : public PressedSurface {
 public:
  void press(PressedNodes& contact, double /*tolerance*/) override {
    contact.penetration = 1.0;
    contact.pressing.setZero();
    for (const Eigen::Index node : contact.nodes) contact.pressing[node] = node < kUndecided ? 1.0 : -kError;
    contact.gap_error = 2.0 * kError;
  }
  [[nodiscard]] Eigen::ArrayXd height(const PressedNodes& contact) override {
    Eigen::ArrayXd height = Eigen::ArrayXd::Ones(kUndecided + 1);
    if (contact.pressing[kUndecided] == 0.0) height[kUndecided] -= kError;
    return height;
  }
  [[nodiscard]] const Eigen::ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return 1.0; }

  static constexpr Eigen::Index kUndecided = 2;
  static constexpr double kError = 1e-9;

 private:
  Eigen::ArrayXd weights_ = Eigen::ArrayXd::Ones(kUndecided + 1);
};

TEST(ActiveSet, ANodeWithNeitherForceNorGapDoesNotChangeTheContactWithoutEnd) {
  UndecidedSurface surface;
  const PressedNodes guess{.pressing = Eigen::ArrayXd::Ones(3), .nodes = {0, 1, 2}, .penetration = 1.0};
  const PressedNodes found = find_contact(
      surface, guess, {.max_passes = 50, .first_tolerance = 1e-11, .tightening = 0.03, .tolerance = 1e-11});
  EXPECT_TRUE(found.converged);
  EXPECT_LT(found.passes, 12);
  EXPECT_TRUE((found.pressing >= 0.0).all());
}

}  // namespace
}  // namespace viscoroll::detail
