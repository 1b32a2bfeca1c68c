// Works of adhesion at the edges of a contact. Reference values: quadrature and root finding with 20 digits (mpmath).
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "cases.hpp"
#include "rolling/adhesion_estimate.hpp"
#include "rolling/edge_works.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {
namespace {

constexpr double kTolerance = 1e-11;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr TimeRange kEdgeTimes{.shortest = 1e-9, .longest = 1e9};

/// Strength of a cubic law that acts as Dugdale's law of a strength.
double cubic(double dugdale) { return dugdale / 0.75; }

/// G from 6 to 3 MPa with a relaxation time of 0.125 s, incompressible.
EdgeCreep rubber_creep() { return {.instantaneous = 1.0 / 24e6, .delayed = {1.0 / 24e6}, .retardation_times = {0.25}}; }

/// Two retardation times.
EdgeCreep two_times() { return {.instantaneous = 2e-8, .delayed = {5e-8, 1.5e-7}, .retardation_times = {1e-3, 2.0}}; }

void expect_ratio(double value, double reference) { EXPECT_NEAR(value / reference, 1.0, kTolerance) << reference; }

/// An edge of the mesh: cohesive zone, strength of Dugdale's law, work, and energy release rate by the relaxed
/// compliance.
struct ReferenceEdge {
  double zone;
  double strength;
  double work;
  double release;
};

void expect_opening(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double speed, const ReferenceEdge& edge) {
  const EdgeWorks works = edge_works(creep, adhesion, edge.zone, speed);
  expect_ratio(works.laws.opening.peak, cubic(edge.strength));
  expect_ratio(works.laws.opening.work, edge.work);
  expect_ratio(works.opening_release, edge.release);
}

void expect_closing(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double speed, const ReferenceEdge& edge) {
  const EdgeWorks works = edge_works(creep, adhesion, edge.zone, speed);
  expect_ratio(works.laws.closing.peak, cubic(edge.strength));
  expect_ratio(works.laws.closing.work, edge.work);
  expect_ratio(works.closing_release, edge.release);
}

std::string message(const EdgeCreep& creep, double speed = 1e-3) {
  try {
    static_cast<void>(edge_works(creep, {.separation_work = 0.05, .bonding_work = 0.05}, 1e-4, speed));
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "none";
}

TEST(EdgeWorks, AgreeWithQuadratureForAStandardLinearSolid) {
  const SurfaceAdhesion adhesion{.separation_work = 1.0, .bonding_work = 1.0, .strength = cubic(1e7)};
  expect_opening(rubber_creep(), adhesion, 1e-8,
                 {.zone = 0.0002443955009787, .strength = 2e5, .work = 1.037211034138, .release = 1.037246721338});
  expect_closing(rubber_creep(), adhesion, 1e-8,
                 {.zone = 0.0002269509757267, .strength = 2e5, .work = 0.9632400422758, .release = 0.9632045515184});
  expect_opening(rubber_creep(), adhesion, 1e-6,
                 {.zone = 0.0003990099856051, .strength = 2e5, .work = 1.690973866655, .release = 1.693450974722});
  expect_closing(rubber_creep(), adhesion, 1e-6,
                 {.zone = 0.0001376017978834, .strength = 2e5, .work = 0.5856637186128, .release = 0.5834692892809});
}

TEST(EdgeWorks, AgreeWithQuadratureForTwoRetardationTimesAndTwoWorks) {
  const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.1, .strength = cubic(5e6)};
  expect_opening(two_times(), adhesion, 1e-3,
                 {.zone = 0.01023077061446, .strength = 3e4, .work = 1.981627942382, .release = 2.579191900451});
  expect_closing(two_times(), adhesion, 1e-3,
                 {.zone = 0.0002792546436673, .strength = 3e4, .work = 0.02886343140478, .release = 0.01005024815341});
  const EdgeWorks works = edge_works(two_times(), adhesion, 1e-3, 1e-3);
  expect_ratio(works.actual_opening_zone, 3.683077421206e-7);
  expect_ratio(works.actual_closing_zone, 1.218462222609e-7);
  expect_opening(two_times(), adhesion, 1e-1,
                 {.zone = 0.01303895237974, .strength = 3e4, .work = 1.07421113311, .release = 3.287138538777});
  expect_closing(two_times(), adhesion, 1e-1,
                 {.zone = 0.0004348672795343, .strength = 3e4, .work = 0.03765394020695, .release = 0.009102790910604});
}

TEST(EdgeWorks, AgreeWithQuadratureWithoutAnInstantaneousCompliance) {
  const EdgeCreep kelvin_voigt{.delayed = {1e-7}, .retardation_times = {0.01}};
  const SurfaceAdhesion adhesion{.separation_work = 0.05, .bonding_work = 0.05, .strength = cubic(1e6)};
  expect_opening(kelvin_voigt, adhesion, 1e-3,
                 {.zone = 0.0003596002002273, .strength = 1e5, .work = 0.4226412424164, .release = 0.4578571952241});
  expect_closing(kelvin_voigt, adhesion, 1e-3,
                 {.zone = 1.222251147045e-5, .strength = 1e5, .work = 0.01161904773568, .release = 0.004286642620274});
}

TEST(EdgeWorks, WithAnInfiniteStrengthReleaseTheRatioOfTheModuli) {
  const SurfaceAdhesion adhesion{.separation_work = 1.0, .bonding_work = 1.0};
  expect_opening(rubber_creep(), adhesion, 1e-2,
                 {.zone = 0.0004712388980385, .strength = 2e5, .work = 1.059796992598, .release = 2.0});
  expect_closing(rubber_creep(), adhesion, 1e-2,
                 {.zone = 0.0003908763599965, .strength = 2e5, .work = 0.9505489251563, .release = 0.5});
  const EdgeWorks works = edge_works(rubber_creep(), adhesion, 1e-4, 1e-2);
  EXPECT_EQ(works.actual_opening_zone, 0.0);
  EXPECT_EQ(works.actual_closing_zone, 0.0);
}

TEST(EdgeWorks, AtHighSpeedReleaseTheRatioOfTheModuliForAnyStrength) {
  const SurfaceAdhesion adhesion{.separation_work = 0.2, .bonding_work = 0.2, .strength = 3e6};
  const EdgeWorks works = edge_works(rubber_creep(), adhesion, 1e-3, 1e8);
  EXPECT_NEAR(works.opening_release, 0.4, 1e-9);
  EXPECT_NEAR(works.closing_release, 0.1, 1e-9);
  EXPECT_NEAR(works.laws.opening.work, 0.2, 1e-9);  // the zone of the mesh is also passed in an instant
  EXPECT_NEAR(works.laws.closing.work, 0.2, 1e-9);
}

TEST(EdgeWorks, AtLowSpeedAndOfElasticBodiesAreTheGivenOnes) {
  const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.1, .strength = 3e6};
  const EdgeCreep elastic{.instantaneous = 1e-7};
  for (const EdgeWorks& works :
       {edge_works(rubber_creep(), adhesion, 1e-3, 0.0), edge_works(elastic, adhesion, 1e-3, 1.0),
        edge_works(elastic, {.separation_work = 0.3, .bonding_work = 0.1}, 1e-3, 1.0)}) {
    expect_ratio(works.laws.opening.work, 0.3);
    expect_ratio(works.laws.closing.work, 0.1);
    expect_ratio(works.opening_release, 0.3);
    expect_ratio(works.closing_release, 0.1);
  }
}

TEST(EdgeWorks, OfAResolvedEdgeAreTheGivenOnes) {
  const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.1, .strength = 3e6};
  const EdgeWorks own = edge_works(two_times(), adhesion, 1e-3, 1e-4);
  const EdgeWorks opening = edge_works(two_times(), adhesion, own.actual_opening_zone, 1e-4);
  const EdgeWorks closing = edge_works(two_times(), adhesion, own.actual_closing_zone, 1e-4);
  expect_ratio(opening.laws.opening.work, 0.3);
  expect_ratio(opening.laws.opening.peak, 3e6);
  expect_ratio(closing.laws.closing.work, 0.1);
  expect_ratio(closing.laws.closing.peak, 3e6);
  const EdgeWorks shorter = edge_works(two_times(), adhesion, 0.5 * own.actual_closing_zone, 1e-4);
  EXPECT_EQ(shorter.laws.closing.peak, 3e6);
  EXPECT_EQ(shorter.laws.closing.work, 0.1);
}

TEST(EdgeWorks, ScaleWithWorkAndModulus) {
  // Lengths scale as work times compliance, stresses as modulus.
  const EdgeWorks works =
      edge_works(two_times(), {.separation_work = 0.3, .bonding_work = 0.1, .strength = 3e6}, 1e-4, 1e-3);
  const EdgeCreep stiffer{.instantaneous = 1e-8, .delayed = {2.5e-8, 0.75e-7}, .retardation_times = {1e-3, 2.0}};
  const EdgeWorks scaled =
      edge_works(stiffer, {.separation_work = 1.2, .bonding_work = 0.4, .strength = 6e6}, 2e-4, 2e-3);
  expect_ratio(scaled.laws.opening.work, 4.0 * works.laws.opening.work);
  expect_ratio(scaled.laws.closing.work, 4.0 * works.laws.closing.work);
  expect_ratio(scaled.laws.opening.peak, 2.0 * works.laws.opening.peak);
}

TEST(EdgeWorks, OfManySpeedsAndStrengthsStayBetweenTheirLimits) {
  const double ratio = two_times().relaxed() / two_times().instantaneous;
  for (double speed = 1e-12; speed < 1e9; speed *= 31.0) {
    double before = 0.0;
    for (double strength = 1e4; strength < 1e12; strength *= 7.0) {
      const EdgeWorks works =
          edge_works(two_times(), {.separation_work = 0.3, .bonding_work = 0.3, .strength = strength}, 1e-3, speed);
      EXPECT_GE(works.opening_release, 0.3 * (1.0 - 1e-9));
      EXPECT_LE(works.opening_release, 0.3 * ratio * (1.0 + 1e-9));
      EXPECT_LE(works.closing_release, 0.3 * (1.0 + 1e-9));
      EXPECT_GE(works.closing_release, 0.3 / ratio * (1.0 - 1e-9));
      EXPECT_GE(works.opening_release, before * (1.0 - 1e-9)) << "a stronger edge is shorter and stiffer";
      before = works.opening_release;
    }
  }
}

TEST(EdgeWorks, WithoutAStrengthRejectMaterialsWhoseWorkDependsOnIt) {
  EXPECT_EQ(
      message({.delayed = {1e-7}, .retardation_times = {0.01}}),
      "adhesion.strength must be finite for a material without instantaneous compliance; give the strength [Pa] or "
      "the range [m], got inf");
  EXPECT_EQ(
      message(two_times()),
      "adhesion.strength must be finite for a material with retardation times from 0.001 to 2 s, because the work "
      "of separation depends on the strength; give the strength [Pa] or the range [m], got inf");
  EXPECT_EQ(message(rubber_creep()), "none");
}

TEST(EdgeCreep, AddsTheOutermostLayersOfBothBodies) {
  const Layer stiff{.thickness = 1e-3, .shear_modulus = Elastic{1e9}, .poisson_ratio = 0.3};
  const Layer rubber{.thickness = 1e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5};
  const CoatedSphere ball{.core_radius = 20e-3, .layers = {stiff, rubber}};
  const EdgeCreep rigid = edge_creep(rolling_pair(ball, CoatedPlane{}), kEdgeTimes);
  expect_ratio(rigid.instantaneous, 1.0 / 24e6);
  ASSERT_EQ(rigid.delayed.size(), 1U);
  expect_ratio(rigid.delayed.front(), 1.0 / 24e6);
  expect_ratio(rigid.retardation_times.front(), 0.25);

  const Layer mat{.thickness = 5e-3, .shear_modulus = Elastic{2e6}, .poisson_ratio = 0.25};
  const EdgeCreep both = edge_creep(rolling_pair(ball, CoatedPlane{.layers = {mat}}), kEdgeTimes);
  expect_ratio(both.instantaneous, 1.0 / 24e6 + 0.75 / 4e6);
  expect_ratio(both.relaxed(), 1.0 / 12e6 + 0.75 / 4e6);
}

TEST(EdgeCreep, OfALayerWithABulkModulusIsExactAtShortAndLongTimes) {
  const double bulk = 8e6;
  const auto compliance = [bulk](double modulus) {
    const double poisson = (3.0 * bulk - 2.0 * modulus) / (2.0 * (3.0 * bulk + modulus));
    return (1.0 - poisson) / (2.0 * modulus);
  };
  const CoatedSphere ball{.core_radius = 20e-3,
                          .layers = {{.thickness = 1e-3, .shear_modulus = cases::rubber(), .bulk_modulus = bulk}}};
  const EdgeCreep creep = edge_creep(rolling_pair(ball, CoatedPlane{}), kEdgeTimes);
  expect_ratio(creep.instantaneous, compliance(6e6));
  expect_ratio(creep.relaxed(), compliance(3e6));
  const CoatedSphere dashpot{
      .core_radius = 20e-3,
      .layers = {{.thickness = 1e-3, .shear_modulus = KelvinVoigt{3e6, 1e4}, .bulk_modulus = bulk}}};
  const EdgeCreep delayed = edge_creep(rolling_pair(dashpot, CoatedPlane{}), kEdgeTimes);
  EXPECT_EQ(delayed.instantaneous, 0.0);
  expect_ratio(delayed.relaxed(), compliance(3e6));
}

/// Torque due to adhesion relative to the torque without, from solutions with adhesion.
struct AdhesiveCase {
  double load;           ///< [N]
  double angular_speed;  ///< [rad/s]
  double work;           ///< [J/m^2]
  double added;          ///< [-]
  double error;          ///< of the solutions [-]
};

TEST(AdhesionEstimate, OfABallOnAMatIsWithinAFifthOfSolutions) {
  // Table of docs/theory/adhesion.md, "When adhesion matters".
  const CoatedSphere ball{.core_radius = 21e-3};
  const CoatedPlane mat{.layers = {{.thickness = 1e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}}};
  const EdgeCreep creep = edge_creep(rolling_pair(ball, mat), kEdgeTimes);
  for (const AdhesiveCase& row : {AdhesiveCase{1.0, 2.5, 0.05, 0.011, 0.002},
                                  {0.1, 2.5, 0.05, 0.095, 0.015},
                                  {1.0, 0.05, 0.05, 0.037, 0.008},
                                  {0.1, 0.5, 0.05, 0.108, 0.01},
                                  {0.1, 0.05, 0.05, 0.22, 0.04},
                                  {0.1, 0.005, 0.05, 1.57, 0.12}}) {
    const Result result = solve(ball, mat, {.load = row.load, .angular_speed = row.angular_speed});
    const double torque = adhesion_torque_estimate(creep, {.separation_work = row.work, .bonding_work = row.work},
                                                   {.half_length = 0.5 * result.contact_length,
                                                    .width = *result.contact_width,
                                                    .radius = 21e-3,
                                                    .speed = 21e-3 * row.angular_speed});
    const double added = torque / result.resisting_torque;
    EXPECT_NEAR(added, row.added, row.error + 0.2 * row.added) << row.load << " " << row.angular_speed;
  }
}

TEST(AdhesionEstimate, InSlowRollingIsThePlateauOfTheRatioOfTheModuli) {
  const SurfaceAdhesion adhesion{.separation_work = 0.05, .bonding_work = 0.05};
  const RollingStrip contact{.half_length = 1e-3, .width = 2e-3, .radius = 0.021, .speed = 1e-7};
  expect_ratio(adhesion_torque_estimate(rubber_creep(), adhesion, contact), 2e-3 * 0.021 * 0.05 * (2.0 - 0.5));
}

TEST(AdhesionEstimate, OfElasticBodiesIsTheDifferenceOfTheWorks) {
  const RollingStrip contact{.half_length = 1e-3, .width = 1.0, .radius = 0.01, .speed = 1.0};
  const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.1, .strength = 1e6};
  expect_ratio(adhesion_torque_estimate({.instantaneous = 1e-7}, adhesion, contact), 0.01 * 0.2);
}

TEST(AdhesionEstimate, IsSmallerForEdgesThatRelax) {
  const RollingStrip contact{.half_length = 1e-3, .width = 1.0, .radius = 0.01, .speed = 1e-6};
  const SurfaceAdhesion stiff{.separation_work = 0.05, .bonding_work = 0.05};
  const SurfaceAdhesion relaxing{.separation_work = 0.05, .bonding_work = 0.05, .strength = 1e6};
  EXPECT_LT(adhesion_torque_estimate(rubber_creep(), relaxing, contact),
            0.5 * adhesion_torque_estimate(rubber_creep(), stiff, contact));
}

}  // namespace
}  // namespace viscoroll::detail
