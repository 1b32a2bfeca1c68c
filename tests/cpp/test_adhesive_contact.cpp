#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "cases.hpp"
#include "contact/adhesive_newton.hpp"
#include "contact/multilevel.hpp"
#include "contact/traction_law.hpp"
#include "influence/table_sums.hpp"
#include "rolling/edge_works.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {
namespace {

TEST(TractionLaw, HasTheWorkAsItsIntegral) {
  TractionLaw law{.peak = Eigen::ArrayXd::Constant(1, 2e6), .work = Eigen::ArrayXd::Constant(1, 0.1)};
  const double range = law.range(0);
  constexpr int kSteps = 1000;
  double work = 0.0;
  for (int i = 0; i < kSteps; ++i) work += law.attraction(0, (i + 0.5) * range / kSteps) * range / kSteps;
  EXPECT_NEAR(work, 0.1, 1e-6);
  EXPECT_EQ(law.attraction(0, 1.01 * range), 0.0);
  EXPECT_EQ(law.attraction(0, -range), law.peak[0]);  // the hard wall carries the rest
  const double change = 1e-6 * range;
  const double gap = 0.3 * range;
  const double quotient = (law.attraction(0, gap - change) - law.attraction(0, gap + change)) / (2.0 * change);
  EXPECT_NEAR(law.slope(0, gap), quotient, 1e-6 * quotient);
}

/// Ball with an elastic coating on a window of nodes that ends beyond the contact.
struct AdheringBall {
  static constexpr int kNodes = 1600;

  AdheringBall()
      : mesh{.nodes_per_revolution = kNodes, .max_order = kNodes},
        orders(layered_body(ball()), 2.5, mesh, 2, watch),
        nodes({outer_radius(ball()), phi_spacing(mesh), theta_spacing(mesh)}, {{-18, 18}, {-18, 18}}) {
    const auto tables = [this](const std::vector<TableRequest>& requests, int phi_reach, int theta_reach) {
      return std::make_shared<const std::vector<Table>>(orders.tables(requests, phi_reach, theta_reach, 2, watch));
    };
    const Formulation formulation{.tangential = false};
    const WindowShape shape = nodes.shape();
    problem.surface = std::make_shared<TableOperator>(
        formulation, nodes.grid(), nodes.window(),
        tables(displacement_tables(formulation), shape.phi_nodes - 1, shape.theta_nodes - 1),
        [tables, formulation](int phi_reach, int theta_reach) {
          return tables(dissipation_tables(formulation), phi_reach, theta_reach);
        },
        Execution{2, watch});
    problem.initial_gap = nodes.height();
    problem.normal_force = 0.05;
    std::vector<Eigen::Index> every(static_cast<std::size_t>(shape.size()));
    std::iota(every.begin(), every.end(), Eigen::Index{0});
    problem.attraction =
        Attraction{.equivalent_load = 0.5,
                   .spacing = outer_radius(ball()) * phi_spacing(mesh),
                   .shortest_zone = 0.0,
                   .x = nodes.x(),
                   .z = nodes.z(),
                   .area = nodes.patch_area(every),
                   .laws = [](double zone, double, const ContactSize& contact) {
                     const EdgeCreep elastic{.instantaneous = 1.0 / 8e6};
                     const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.3};
                     return edge_laws(elastic, adhesion, edge_intensities(elastic, adhesion, 1.0), zone, 1.0, contact);
                   }};
  }

  static CoatedSphere ball() {
    return {.core_radius = 20e-3, .layers = {{.thickness = 3e-3, .shear_modulus = Elastic{2e6}, .poisson_ratio = 0.5}}};
  }

  Observer observer;
  Watch watch{observer};
  Mesh mesh;
  CoatingSum orders;
  SurfaceWindow nodes;
  ContactProblem problem;
};

TEST(AdhesiveContact, SatisfiesItsConditions) {
  const AdheringBall given;
  const LocatedContact located = solve_multilevel(given.problem, 1e-5, {.max_iterations = 2000});
  const ContactSolution& contact = located.contact;
  ASSERT_TRUE(contact.adhesion);
  const TractionLaw law = given.problem.attraction->law(contact.adhesion->zone_length, contact.adhesion->size);
  const Eigen::ArrayXd pressing = pressing_force(contact);
  EXPECT_NEAR(pressing.sum(), 0.05, 1e-12);
  const Eigen::ArrayXd gap =
      given.problem.initial_gap + given.problem.surface->normal_displacement(pressing) - contact.penetration;
  const double size = pressing.abs().maxCoeff();
  const double depth = gap.maxCoeff();
  EXPECT_GT(contact.contact.size(), 40);
  EXPECT_GT(contact.adhesion->zone.size(), 20);
  EXPECT_GT(gap.minCoeff(), -1e-9 * depth);
  for (const Eigen::Index node : contact.contact) {
    EXPECT_LT(gap[node], 1e-9 * depth);
    EXPECT_GT(pressing[node] + given.problem.attraction->area[node] * law.peak[node], 0.0);
  }
  for (const Eigen::Index node : contact.adhesion->zone) {
    EXPECT_NEAR(pressing[node], -given.problem.attraction->area[node] * law.attraction(node, gap[node]), 1e-8 * size);
  }
}

TEST(AdhesiveContact, OfAReversibleLawHasNoHysteresis) {
  AdheringBall given;
  ContactProblem& problem = given.problem;
  const LocatedContact located = solve_multilevel(problem, 1e-5, {.max_iterations = 2000});
  // With three spacings per cohesive length E* w / peak^2, a mesh causes no hysteresis of its own. The zone is 2.495
  // cohesive lengths long.
  const double zone = 3.0 * 2.495 * problem.attraction->spacing;
  const TractionLaw law = problem.attraction->law(zone, {});
  AdhesiveNewton newton(problem, {.max_iterations = 2000});
  AdhesiveState state{.pressing = pressing_force(located.contact), .penetration = located.contact.penetration};
  state = newton.solve(problem, law, state);
  ASSERT_TRUE(state.converged);
  const auto loads_on_path = [&](double from, double to) {
    constexpr int kSteps = 20;
    std::vector<double> loads;
    for (int i = 0; i <= kSteps; ++i) {
      problem.penetration = from + i * (to - from) / kSteps;
      state = newton.solve(problem, law, state);
      EXPECT_TRUE(state.converged);
      loads.push_back(state.load());
    }
    return loads;
  };
  const double start = state.penetration;
  const double end = 1.5 * start;
  const std::vector<double> approaching = loads_on_path(start, end);
  std::vector<double> retreating = loads_on_path(end, start);
  EXPECT_GT(approaching.back(), 2.0 * approaching.front());
  for (std::size_t i = 0; i < approaching.size(); ++i) {
    EXPECT_NEAR(approaching[i], retreating[approaching.size() - 1 - i], 1e-9 * approaching.back());
  }
}

}  // namespace
}  // namespace viscoroll::detail
