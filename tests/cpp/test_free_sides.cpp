// Contribution of the faces of treads to the influence of an unbounded tread.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "influence/side_influence.hpp"
#include "influence/table.hpp"
#include "section/side_difference.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

CoatedWheel tread(double core, double width, std::vector<Layer> layers, double crown = INFINITY) {
  return {.core_radius = core, .layers = std::move(layers), .width = width, .crown_radius = crown};
}

/// The splines are cubic in ln m and end with the slope of 1/m.
TEST(SideSum, SplinesAreExactForCubicPolynomialsOfTheLogarithm) {
  Eigen::ArrayXd sampled(9);
  sampled << 0.0, Eigen::ArrayXd::LinSpaced(8, 0.0, 4.0).exp();
  const auto cubic = [](double x) { return 2.0 + (x - 4.0) * (-2.0 + (x - 4.0) * (0.5 - 0.1 * (x - 4.0))); };
  Eigen::VectorXd values(9);
  values[0] = -7.0;  // order 0 is an independent function
  for (Index i = 1; i < 9; ++i) values[i] = cubic(std::log(sampled[i]));
  Eigen::ArrayXd orders(5);
  orders << 0.0, 1.0, 2.5, 40.0, 2.0 * sampled[8];
  const Eigen::VectorXd at_orders = shares_of_samples(sampled, orders) * values;
  EXPECT_DOUBLE_EQ(at_orders[0], -7.0);
  for (Index i = 1; i < 4; ++i) EXPECT_NEAR(at_orders[i], cubic(std::log(orders[i])), 1e-12);
  EXPECT_NEAR(at_orders[4], 0.5 * cubic(4.0), 1e-12);
}

/// A crowned tread of two dissimilar layers, with a mesh and a speed.
class SideInfluence : public testing::Test {
 protected:
  static constexpr double kSpeed = 2.5;
  static constexpr int kReach = 7;
  const CoatedWheel wheel_ =
      tread(40e-3, 30e-3,
            {{.thickness = 6e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5},
             {.thickness = 4e-3, .shear_modulus = standard_linear_solid(4e6, 1e6, 0.02), .poisson_ratio = 0.45}},
            300e-3);
  const LayeredBody layers_ = layered_body(CoatedCylinder{.core_radius = 40e-3, .layers = wheel_.layers});
  const Mesh mesh_{.nodes_per_revolution = 400};
  const Observer silent_;
  Watch watch_{silent_};
  // Coarse elements suffice to test sums.
  static constexpr SectionFineness kCoarse{.finest = 0.25, .growth = 0.5, .largest = 0.5};
  const SideDifference sections_{wheel_, true, kCoarse};

  [[nodiscard]] std::vector<double> orders_of_samples() const {
    const Eigen::ArrayXd orders = sampled_orders(wheel_, kCoarse);
    return {orders.begin(), orders.end()};
  }
  [[nodiscard]] std::shared_ptr<const SampledDifference> sampled() {
    return std::make_shared<const SampledDifference>(
        sections_.sampled(HarmonicBody(layers_, kSpeed, orders_of_samples()), 1, watch_));
  }
  [[nodiscard]] SideSum sum(std::vector<OrderBand> bands) {
    const Eigen::VectorXcd smallest = inverse_outer_modulus(HarmonicBody(layers_, kSpeed, all_orders(bands)));
    return {sampled(), std::move(bands), smallest, mesh_};
  }
};

/// Compare with the sum of all integer orders up to the last order of the octaves.
TEST_F(SideInfluence, OctavesAgreeWithTheSumOfAllOrders) {
  const SideSum by_octaves = sum(phi_bands(layers_, kSpeed, mesh_));
  const SideSum one_by_one = sum(whole_orders(40 * mesh_.nodes_per_revolution, mesh_.nodes_per_revolution));
  for (const SideRequest& request :
       {SideRequest{.phi_reach = kReach, .phi_shift = 0.25}, SideRequest{.phi_reach = kReach, .power = true}}) {
    const Eigen::MatrixXd entries = by_octaves.difference()->parts[kEvenPart].real();
    const Eigen::MatrixXd octaves = by_octaves.factors(request).values.real() * entries;
    const Eigen::MatrixXd orders = one_by_one.factors(request).values.real() * entries;
    // At the end of the samples, the difference has a kink, which octaves smooth slightly.
    EXPECT_LT((octaves - orders).cwiseAbs().maxCoeff(), 2e-4 * orders.cwiseAbs().maxCoeff());
  }
}

/// Wide patches of one entry agree with the widened table.
TEST_F(SideInfluence, WidePatchesAgreeWithWidenedTables) {
  const SideSum orders = sum(phi_bands(layers_, kSpeed, mesh_));
  const SideFactors fine = orders.factors({.phi_reach = kReach, .phi_shift = 0.25});
  const Eigen::VectorXcd entry = orders.difference()->parts[kEvenPart].col(0);
  const auto column = [&](const SideFactors& factors) { return Eigen::VectorXd((factors.values * entry).real()); };
  Table table(kReach, 0, false);
  for (int j = -kReach; j <= kReach; ++j) table.row(j)[0] = column(fine)[j + kReach];
  for (const double downstream : {0.0, 0.25}) {
    const Table expected = widened(table, 2, downstream);
    const SideFactors wide = widened(fine, 2, downstream);
    ASSERT_EQ(wide.phi_reach, expected.phi_reach());
    for (int j = -wide.phi_reach; j <= wide.phi_reach; ++j) {
      EXPECT_NEAR(column(wide)[j + wide.phi_reach], expected(j, 0), 1e-14 * table(0, 0));
    }
  }
}

/// Compare with the sum over all pairs of nodes; the effect of a load is the sum of its even and its odd part.
TEST_F(SideInfluence, ProductIsTheSumOverAllPairs) {
  const SideSum orders = sum(phi_bands(layers_, kSpeed, mesh_));
  const SampledDifference& difference = *orders.difference();
  const SideFactors factors = orders.factors({.phi_reach = kReach});
  constexpr WindowShape kShape{5, 6};
  const double face = difference.z[difference.z.size() - 1];
  // Columns of nodes are lines of the section; only the widths of their patches differ.
  const double line = difference.z[1];
  const TreadColumns columns{.first = -2, .spacing = line};
  ASSERT_LT(4.0 * line, face);
  const SideProduct product(kShape, columns, difference, factors, false);
  Eigen::ArrayXXd loads = Eigen::ArrayXXd::Zero(kShape.size(), 3);
  const Index from = 1 * 6 + 3;  // row 1, column 1 from the middle
  loads(from, 0) = 1.0;
  loads(from, 1) = -0.5;
  loads(from, 2) = 0.25;
  const Eigen::ArrayXXd moved = product.apply(loads);
  const Index lines = difference.z.size();
  // A patch around the first line extends from the middle of one element to the middle of the next one, so a mean over
  // it is one of the quadratic shape functions.
  const auto gathered = [&](bool odd) {
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(lines);
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i) {
      const double z = line * (0.5 + (i + 0.5) / kPoints);
      Index first = 0;
      while (z > difference.z[first + 2]) first += 2;
      const auto values =
          quadratic_shares((z - difference.z[first + 1]) / (difference.z[first + 1] - difference.z[first]));
      for (Index n = 0; n < 3; ++n) shares[first + n] += values[static_cast<std::size_t>(n)] / kPoints;
    }
    if (odd) shares[0] = 0.0;
    return shares;
  };
  for (Index row = 0; row < 5; ++row) {
    for (const int side : {1, -1}) {
      Eigen::Vector3d expected = Eigen::Vector3d::Zero();
      for (const Parity part : {kEvenPart, kOddPart}) {
        const Eigen::VectorXd table =
            (factors.values.row(row - 1 + kReach) * difference.parts[part]).real().transpose();
        const Eigen::MatrixXd matrix = table.reshaped(3 * lines, 3 * lines);
        Eigen::VectorXd amplitudes(3 * lines);
        for (Index q = 0; q < 3; ++q) {
          amplitudes.segment(q * lines, lines) = loads(from, q) * gathered((q == 2) == (part == kEvenPart));
        }
        const Eigen::VectorXd shown = matrix * amplitudes;
        for (Index p = 0; p < 3; ++p) {
          const bool odd = (p == 2) == (part == kEvenPart);
          expected[p] += (odd && side < 0 ? -1.0 : 1.0) * shown[p * lines + 1];
        }
      }
      const Index node = row * 6 + 2 + side;
      EXPECT_LT((moved.row(node).matrix().transpose() - expected).cwiseAbs().maxCoeff(),
                1e-6 * moved.abs().maxCoeff());  // error of the rectangle rule
    }
  }
}

/// Layers with one relaxation function are solved with real moduli; a tiny difference between them requires complex
/// ones.
TEST_F(SideInfluence, RealAndComplexSectionsAgree) {
  const auto difference = [&](double outer_time) {
    CoatedCylinder body{.core_radius = 40e-3, .layers = wheel_.layers};
    body.layers[1].shear_modulus = standard_linear_solid(4e6, 2e6, outer_time);
    return sections_.sampled(HarmonicBody(layered_body(body), kSpeed, orders_of_samples()), 1, watch_).parts[kEvenPart];
  };
  const Eigen::MatrixXcd real = difference(0.125);
  const Eigen::MatrixXcd complex = difference(0.125 * (1.0 + 1e-9));
  EXPECT_NE(real, complex);
  EXPECT_LT((real - complex).cwiseAbs().maxCoeff(), 1e-7 * real.cwiseAbs().maxCoeff());
}

/// A tread of 10 mm thickness on a hub of 40 mm radius.
CoatedWheel thick_wheel(double width, double crown, Sides sides = Sides::free) {
  return {.core_radius = 40e-3,
          .layers = {{.thickness = 10e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}},
          .width = width,
          .crown_radius = crown,
          .sides = sides};
}

/// The cache distinguishes treads that differ only in the radius of the crown, one of which is infinite.
TEST(TreadCache, DistinguishesCrownedFromFlatTreads) {
  const Observer silent;
  Watch watch(silent);
  const auto of_tread = [&](double crown, auto find) {
    const CoatedWheel wheel = thick_wheel(30e-3, crown);
    const Eigen::ArrayXd orders = sampled_orders(wheel);
    return find(wheel, HarmonicBody(layered_body(wheel), 2.5, {orders.begin(), orders.end()}));
  };
  const auto kept = [&](double crown) {
    return of_tread(crown, [&](const CoatedWheel& wheel, const HarmonicBody& body) {
      return cached_difference(wheel, body, false, 1, watch)->parts[kEvenPart];
    });
  };
  const Eigen::MatrixXcd flat = kept(INFINITY);
  const Eigen::MatrixXcd crowned = of_tread(0.1, [&](const CoatedWheel& wheel, const HarmonicBody& body) {
    return SideDifference(wheel, false).sampled(body, 1, watch).parts[kEvenPart];
  });
  EXPECT_EQ(kept(0.1), crowned);
  EXPECT_EQ(kept(INFINITY), flat);
}

Result rolled(const CoatedWheel& wheel, double load, double speed, double friction = 0.0) {
  const Mesh mesh{.nodes_per_revolution = 800, .theta_nodes_per_revolution = 400};
  return solve(wheel, {.load = load, .angular_speed = speed, .friction = friction}, {.mesh = mesh});
}

/// A flat wheel three times as wide as its tread is thick. An independent program computes its compliance by finite
/// elements of the section, order by order, extrapolated in the size of its patches.
TEST(FreeSides, FlatWheelAgreesWithFiniteElements) {
  constexpr double kMesh = 3e-3;  // error of the mesh of 0.4 mm by 0.8 mm
  const CoatedWheel wheel = thick_wheel(30e-3, INFINITY);
  const Result slow = rolled(wheel, 500.0, 2.5);
  EXPECT_NEAR(slow.resisting_torque, 306.4e-3, kMesh * 306.4e-3);
  EXPECT_NEAR(*slow.penetration, 0.6243e-3, kMesh * 0.6243e-3);
  const Result fast = rolled(wheel, 500.0, 25.0);
  EXPECT_NEAR(fast.bulk_power / 25.0, 35.4e-3, kMesh * 35.4e-3);
  EXPECT_NEAR(*fast.penetration, 0.5674e-3, kMesh * 0.5674e-3);
}

/// The faces are at 20 mm, and the contact ends 2.5 mm before them. By the same program, the torque of an unbounded
/// tread, 247.49 mN m, grows by 8.0 % due to the faces and falls by 2.2 % due to the thinner sides; the penetration,
/// 0.58429 mm, changes by 7.6 and 2.0 %.
TEST(FreeSides, CrownedWheelOnAStraightHub) {
  const Result result = rolled(thick_wheel(40e-3, 300e-3), 500.0, 2.5);
  constexpr double kDigitsAndMesh = 4e-3;
  EXPECT_NEAR(result.resisting_torque / 247.49e-3, 1.080 * 0.978, kDigitsAndMesh);
  EXPECT_NEAR(*result.penetration / 0.58429e-3, 1.076 * 0.980, kDigitsAndMesh);
}

/// With a hub crowned like the tread and equal radii, the wheel is a ball with all of its curvature. The faces are
/// three thicknesses away from the contact.
TEST(FreeSides, RoundWheelAgreesWithABall) {
  const std::vector<Layer> layers{{.thickness = 2e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}};
  CoatedWheel wheel = tread(48e-3, 20e-3, layers, 50e-3);
  wheel.hub = Hub::crowned;
  const LoadCase load_case{.load = 100.0, .angular_speed = 2.5};
  const Mesh mesh{.nodes_per_revolution = 1600};
  const Result result = solve(wheel, load_case, {.mesh = mesh});
  const Result ball = solve(CoatedSphere{.core_radius = 48e-3, .layers = layers}, load_case,
                            {.mesh = mesh, .curvature = Curvature::exact});
  // The neglected terms are of second order in the curvature, a fraction of (a/R)^2 = 6e-3.
  EXPECT_NEAR(result.resisting_torque / ball.resisting_torque, 1.0, 1e-3);
  EXPECT_NEAR(*result.penetration / *ball.penetration, 1.0, 1e-3);
}

/// A crown radius below the tread thickness: an inline skate wheel, compared with elements of its true section loaded
/// along its normals.
TEST(FreeSides, SkateWheel) {
  CoatedWheel wheel = tread(
      22e-3, 23.2e-3,
      {{.thickness = 18e-3, .shear_modulus = standard_linear_solid(12e6, 9e6, 0.02), .poisson_ratio = 0.5}}, 12e-3);
  const Result result =
      solve(wheel, {.load = 200.0, .angular_speed = 10.0}, {.mesh = Mesh{.nodes_per_revolution = 1600}});
  EXPECT_NEAR(result.resisting_torque, 72.92e-3, 0.02 * 72.92e-3);
  EXPECT_NEAR(*result.penetration, 0.7499e-3, 0.02 * 0.7499e-3);
}

/// From 16 thicknesses on, the section contains only the parts next to the faces.
TEST(FreeSides, EffectDecreasesSmoothlyWithTheWidth) {
  const auto per_width = [](double width) {
    const LoadCase load_case{.load = 500.0 / 30e-3 * width, .angular_speed = 2.5};
    const Result result = solve(thick_wheel(width, INFINITY), load_case, {.mesh = Mesh{.nodes_per_revolution = 400}});
    return std::array{result.bulk_power / width, *result.penetration};
  };
  const auto narrow = per_width(157e-3);
  const auto middle = per_width(159e-3);
  const auto wide = per_width(161e-3);
  for (const std::size_t of : {std::size_t{0}, std::size_t{1}}) {
    // The effect of the faces is proportional to 1/width, and decreases here by 1e-3 of the total.
    const double step = narrow[of] - middle[of];
    EXPECT_GT(step, 3e-4 * middle[of]);
    EXPECT_NEAR(middle[of] - wide[of], step, 1e-4 * middle[of]);
  }
}

/// For a crown radius much smaller than the tread thickness, the first order in its curvature gives unbounded sides a
/// negative compliance.
TEST(FreeSides, AcceptCrownsThatUnboundedSidesReject) {
  const auto pressed = [](Sides sides) {
    const CoatedWheel wheel = tread(2.2e-3, 30e-6,
                                    {{.thickness = 120e-6, .shear_modulus = Elastic{1e4}, .poisson_ratio = 0.43},
                                     {.thickness = 170e-6, .shear_modulus = Elastic{4e8}, .poisson_ratio = 0.1}},
                                    20e-6);
    CoatedWheel with_sides = wheel;
    with_sides.sides = sides;
    return solve(with_sides, {.load = 1e-8, .angular_speed = 0.1}, {.mesh = Mesh{.nodes_per_revolution = 2500}});
  };
  EXPECT_GT(*pressed(Sides::free).penetration, 0.0);
  try {
    std::ignore = pressed(Sides::unbounded);
    ADD_FAILURE() << "a crown that rises where it is pressed was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).rfind("crown_radius must be at least the tread thickness, 0.00029 m", 0), 0U)
        << error.what();
  }
}

TEST(FreeSides, DoNotAffectSmallContacts) {
  const Result free = rolled(thick_wheel(90e-3, INFINITY, Sides::free), 500.0, 2.5);
  const Result unbounded = rolled(thick_wheel(90e-3, INFINITY, Sides::unbounded), 500.0, 2.5);
  EXPECT_GT(free.resisting_torque, unbounded.resisting_torque);
  CoatedWheel crowned = thick_wheel(90e-3, 300e-3);
  crowned.hub = Hub::crowned;
  const Result far = rolled(crowned, 300.0, 2.5);
  crowned.sides = Sides::unbounded;
  // Free sides contain the crown in the section, and unbounded sides to first order.
  EXPECT_NEAR(far.resisting_torque / rolled(crowned, 300.0, 2.5).resisting_torque, 1.0, 2e-3);
}

/// Relative difference of the lateral tractions, all of which are caused by the crown.
double sideways_difference(const Result& one, const Result& other) {
  double difference = 0.0;
  double size = 0.0;
  for (std::size_t node = one.pressure.size(); node < one.shear_traction.size(); ++node) {
    difference = std::hypot(difference, one.shear_traction[node] - other.shear_traction[node]);
    size = std::hypot(size, other.shear_traction[node]);
  }
  return difference / size;
}

/// The contact, 1.4 by 4.7 mm, is smaller than the elements below it, and the faces are 3.5 thicknesses away.
TEST(FreeSides, DoNotAffectTheSlipOfSmallContacts) {
  const auto result = [](Sides sides) {
    CoatedWheel wheel = thick_wheel(80e-3, 300e-3, sides);
    wheel.hub = Hub::crowned;
    const Mesh mesh{.nodes_per_revolution = 1600, .theta_nodes_per_revolution = 1600};
    return solve(wheel, {.load = 5.0, .angular_speed = 2.5, .friction = 0.1}, {.mesh = mesh});
  };
  const Result free = result(Sides::free);
  const Result unbounded = result(Sides::unbounded);
  ASSERT_EQ(free.pressure.size(), unbounded.pressure.size());
  // The product of both curvatures changes the effect of the crown, and the elongation due to rolling, by the relative
  // amount h / R_c = 1/30.
  EXPECT_LT(sideways_difference(free, unbounded), 1e-2);
  EXPECT_NEAR(*free.creepage / *unbounded.creepage, 1.0, 3e-2);
  EXPECT_NEAR(free.slip_power / unbounded.slip_power, 1.0, 1e-2);
  EXPECT_NEAR(free.resisting_torque / unbounded.resisting_torque, 1.0, 1e-3);
  // With 14 nodes across, both errors are 2e-2.
  EXPECT_NEAR(free.energy_balance_error, unbounded.energy_balance_error, 1e-3);
}

TEST(FreeSides, PowerBalancesWithFriction) {
  for (const double friction : {0.0, 0.3}) {
    EXPECT_LT(rolled(thick_wheel(30e-3, INFINITY), 500.0, 2.5, friction).energy_balance_error, 3e-3);
  }
}

/// Layers with different relaxation functions have complex sections at each speed.
TEST(FreeSides, PowerOfDissimilarLayersEqualsTheLoss) {
  const CoatedWheel wheel =
      tread(40e-3, 40e-3,
            {{.thickness = 6e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5},
             {.thickness = 4e-3, .shear_modulus = standard_linear_solid(4e6, 1e6, 0.02), .poisson_ratio = 0.45}},
            300e-3);
  const Result result = rolled(wheel, 300.0, 2.5);
  EXPECT_LT(result.energy_balance_error, 3e-3);
  // Unbounded sides give 451.6 mN m. The faces, 0.3 mm from the contact, add more than the thinner sides subtract.
  EXPECT_GT(result.resisting_torque, 451.6e-3);
}

}  // namespace
}  // namespace viscoroll::detail
