// Works of adhesion at the edges of a contact.
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

/// G from 6 to 3 MPa with a relaxation time of 0.125 s, incompressible.
EdgeCreep rubber_creep() { return {.instantaneous = 1.0 / 24e6, .delayed = {1.0 / 24e6}, .retardation_times = {0.25}}; }

/// Two retardation times.
EdgeCreep two_times() { return {.instantaneous = 2e-8, .delayed = {5e-8, 1.5e-7}, .retardation_times = {1e-3, 2.0}}; }

void expect_ratio(double value, double reference) { EXPECT_NEAR(value / reference, 1.0, kTolerance) << reference; }

/// Edges of a standard linear solid whose cohesive zone has the length 1 and the peak 1. Releases are those by the
/// relaxed compliance.
struct ReferenceEdge {
  double ratio;    ///< of the instantaneous and the relaxed modulus
  double time;     ///< in which material passes the zone, per relaxation time
  double regular;  ///< B l / K
  double opening;  ///< G_open / w
  double opening_work;
  double closing;  ///< G_close / w
  double closing_work;
};

EdgeCreep standard_solid(double ratio, double relaxation_time) {
  return {.instantaneous = 1.0 / ratio, .delayed = {1.0 - 1.0 / ratio}, .retardation_times = {ratio * relaxation_time}};
}

double opening_ratio(const CohesiveEdge& edge, double relaxed = 1.0) {
  return 0.5 * edge.intensity * edge.intensity * relaxed / edge.work;
}
double closing_ratio(const CohesiveEdge& edge, double relaxed = 1.0) {
  return 0.5 * edge.intensity * edge.intensity / relaxed / edge.work;
}

TEST(CohesiveEdge, ReleasesTheWorkOfAnElasticSolidForAnyPressure) {
  // J integral. The weak singularity at the end of the zone limits the polynomials to about 1e-9.
  for (const double regular : {0.0, 0.3, 3.0, 100.0}) {
    EXPECT_NEAR(opening_ratio(opening_edge({.instantaneous = 1.0}, 1.0, regular)), 1.0, 1e-9) << regular;
    EXPECT_NEAR(closing_ratio(closing_edge({.instantaneous = 1.0}, 1.0, regular)), 1.0, 1e-9) << regular;
  }
}

TEST(CohesiveEdge, OfAnElasticSolidHasTheLengthThatMeshesAssume) {
  // python -m tests.reference.adhesion edges. The length relative to w / (J peak^2) determines the spacing of meshes.
  EXPECT_NEAR(1.0 / opening_edge({.instantaneous = 1.0}, 1.0).work, 2.495, 5e-4);
}

TEST(CohesiveEdge, AgreesWithAPiecewiseLinearTraction) {
  // `python -m tests.reference.adhesion edges`, extrapolated from 200 and 400 elements.
  for (const ReferenceEdge& row : {ReferenceEdge{2, 10, 0, 1.265277, 0.3894318, 0.776878, 0.3225752},
                                   {2, 1, 0.3, 1.803096, 0.3438079, 0.5524372, 0.3120215},
                                   {10, 10, 0, 3.405904, 0.1860383, 0.2640236, 0.1143022},
                                   {10, 1, 0.5, 8.200416, 0.09978689, 0.1206628, 0.0848311},
                                   {70, 100, 0, 3.3472, 0.204723, 0.2533357, 0.1121438},
                                   {70, 10, 2, 19.52837, 0.2064475, 0.04776856, 0.1227162},
                                   {70, 1, 0.3, 56.26707, 0.01219379, 0.0175071, 0.01008364}}) {
    const EdgeCreep creep = standard_solid(row.ratio, 1.0);
    const CohesiveEdge opening = opening_edge(creep, row.time, row.regular);
    const CohesiveEdge closing = closing_edge(creep, row.time, row.regular);
    EXPECT_NEAR(opening_ratio(opening) / row.opening, 1.0, 2e-5) << row.ratio << " " << row.time;
    EXPECT_NEAR(closing_ratio(closing) / row.closing, 1.0, 2e-5) << row.ratio << " " << row.time;
    EXPECT_NEAR(opening.work / row.opening_work, 1.0, 2e-5) << row.ratio << " " << row.time;
    EXPECT_NEAR(closing.work / row.closing_work, 1.0, 2e-5) << row.ratio << " " << row.time;
  }
}

TEST(CohesiveEdge, OfAFastAndOfASlowEdgeReleaseTheRatioOfTheModuli) {
  for (const double regular : {0.0, 0.5}) {
    EXPECT_NEAR(opening_ratio(opening_edge(standard_solid(70.0, 1.0), 1e-9, regular)), 70.0, 1e-6);
    EXPECT_NEAR(closing_ratio(closing_edge(standard_solid(70.0, 1.0), 1e-9, regular)), 1.0 / 70.0, 1e-9);
    EXPECT_NEAR(opening_ratio(opening_edge(standard_solid(70.0, 1.0), 1e12, regular)), 1.0, 1e-8);
    EXPECT_NEAR(closing_ratio(closing_edge(standard_solid(70.0, 1.0), 1e12, regular)), 1.0, 1e-8);
  }
}

EdgeLaws laws_at(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double zone, double speed,
                 const ContactSize& contact = {}) {
  return edge_laws(creep, adhesion, edge_intensities(creep, adhesion, speed), zone, speed, contact);
}

double opening_release(const EdgeCreep& creep, const EdgeIntensities& edges) {
  return 0.5 * edges.opening * edges.opening * creep.relaxed();
}
double closing_release(const EdgeCreep& creep, const EdgeIntensities& edges) {
  return 0.5 * edges.closing * edges.closing / creep.relaxed();
}

TEST(EdgeWorks, AtHighSpeedReleaseTheRatioOfTheModuliForAnyStrength) {
  const SurfaceAdhesion adhesion{.separation_work = 0.2, .bonding_work = 0.2, .strength = 3e6};
  const EdgeIntensities edges = edge_intensities(rubber_creep(), adhesion, 1e8);
  EXPECT_NEAR(opening_release(rubber_creep(), edges), 0.4, 1e-9);
  EXPECT_NEAR(closing_release(rubber_creep(), edges), 0.1, 1e-9);
  const EdgeLaws laws = laws_at(rubber_creep(), adhesion, 1e-3, 1e8);
  EXPECT_NEAR(laws.opening.work, 0.2, 1e-9);  // the zone of the mesh is also passed in an instant
  EXPECT_NEAR(laws.closing.work, 0.2, 1e-9);
}

TEST(EdgeWorks, WithAnInfiniteStrengthReleaseTheRatioOfTheModuli) {
  const SurfaceAdhesion adhesion{.separation_work = 1.0, .bonding_work = 1.0};
  const EdgeIntensities edges = edge_intensities(rubber_creep(), adhesion, 1e-2);
  expect_ratio(opening_release(rubber_creep(), edges), 2.0);
  expect_ratio(closing_release(rubber_creep(), edges), 0.5);
  EXPECT_EQ(edges.opening_zone, 0.0);
  EXPECT_EQ(edges.closing_zone, 0.0);
}

TEST(EdgeWorks, AtLowSpeedAndOfElasticBodiesAreTheGivenOnes) {
  constexpr double kEdge = 1e-9;  // of the solution of the zone
  const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.1, .strength = 3e6};
  const SurfaceAdhesion infinite{.separation_work = 0.3, .bonding_work = 0.1};
  const ContactSize contact{.center = 0.0, .half_length = 2e-3, .pressure = 1e5};
  const EdgeCreep elastic{.instantaneous = 1e-7};
  for (const EdgeLaws& laws :
       {laws_at(rubber_creep(), adhesion, 1e-3, 0.0), laws_at(elastic, adhesion, 1e-3, 1.0),
        laws_at(elastic, adhesion, 1e-3, 1.0, contact), laws_at(elastic, infinite, 1e-3, 1.0, contact)}) {
    EXPECT_NEAR(laws.opening.work, 0.3, 0.3 * kEdge);
    EXPECT_NEAR(laws.closing.work, 0.1, 0.1 * kEdge);
  }
  const EdgeIntensities strong = edge_intensities(elastic, infinite, 1.0);
  EXPECT_NEAR(opening_release(elastic, strong), 0.3, 0.3 * kEdge);
  EXPECT_NEAR(closing_release(elastic, strong), 0.1, 0.1 * kEdge);
  const EdgeIntensities edges = edge_intensities(rubber_creep(), adhesion, 0.0);
  EXPECT_NEAR(opening_release(rubber_creep(), edges), 0.3, 0.3 * kEdge);
  EXPECT_NEAR(closing_release(rubber_creep(), edges), 0.1, 0.1 * kEdge);
}

TEST(EdgeWorks, OfAResolvedEdgeAreTheGivenOnes) {
  const SurfaceAdhesion adhesion{.separation_work = 0.3, .bonding_work = 0.1, .strength = 3e6};
  const EdgeIntensities own = edge_intensities(two_times(), adhesion, 1e-4);
  const EdgeLaws opening = laws_at(two_times(), adhesion, own.opening_zone, 1e-4);
  const EdgeLaws closing = laws_at(two_times(), adhesion, own.closing_zone, 1e-4);
  expect_ratio(opening.opening.work, 0.3);
  expect_ratio(opening.opening.peak, 3e6);
  expect_ratio(closing.closing.work, 0.1);
  expect_ratio(closing.closing.peak, 3e6);
  const EdgeLaws shorter = laws_at(two_times(), adhesion, 0.5 * own.closing_zone, 1e-4);
  EXPECT_EQ(shorter.closing.peak, 3e6);
  EXPECT_EQ(shorter.closing.work, 0.1);
}

TEST(EdgeWorks, ScaleWithWorkAndModulus) {
  // Lengths scale as work times compliance, stresses as modulus.
  const ContactSize contact{.center = 0.0, .half_length = 1e-3, .pressure = 1e5};
  const EdgeLaws laws =
      laws_at(two_times(), {.separation_work = 0.3, .bonding_work = 0.1, .strength = 3e6}, 1e-4, 1e-3, contact);
  const EdgeCreep stiffer{.instantaneous = 1e-8, .delayed = {2.5e-8, 0.75e-7}, .retardation_times = {1e-3, 2.0}};
  const EdgeLaws scaled = laws_at(stiffer, {.separation_work = 1.2, .bonding_work = 0.4, .strength = 6e6}, 2e-4, 2e-3,
                                  {.center = 0.0, .half_length = 2e-3, .pressure = 2e5});
  expect_ratio(scaled.opening.work, 4.0 * laws.opening.work);
  expect_ratio(scaled.closing.work, 4.0 * laws.closing.work);
  expect_ratio(scaled.opening.peak, 2.0 * laws.opening.peak);
  expect_ratio(scaled.closing.peak, 2.0 * laws.closing.peak);
}

TEST(EdgeWorks, OfManySpeedsAndStrengthsStayBetweenTheirLimits) {
  const double ratio = two_times().relaxed() / two_times().instantaneous;
  for (double speed = 1e-12; speed < 1e9; speed *= 31.0) {
    double before = 0.0;
    for (double strength = 1e4; strength < 1e12; strength *= 7.0) {
      const EdgeIntensities edges =
          edge_intensities(two_times(), {.separation_work = 0.3, .bonding_work = 0.3, .strength = strength}, speed);
      const double opening = opening_release(two_times(), edges);
      const double closing = closing_release(two_times(), edges);
      EXPECT_GE(opening, 0.3 * (1.0 - 1e-8));
      EXPECT_LE(opening, 0.3 * ratio * (1.0 + 1e-8));
      EXPECT_LE(closing, 0.3 * (1.0 + 1e-8));
      EXPECT_GE(closing, 0.3 / ratio * (1.0 - 1e-8));
      EXPECT_GE(opening, before * (1.0 - 1e-8)) << "a stronger edge is shorter and stiffer";
      before = opening;
    }
  }
}

std::string message(const EdgeCreep& creep, double speed = 1e-3) {
  try {
    static_cast<void>(edge_intensities(creep, {.separation_work = 0.05, .bonding_work = 0.05}, speed));
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "none";
}

TEST(EdgeWorks, WithoutAStrengthRejectMaterialsWhoseWorkDependsOnIt) {
  EXPECT_EQ(
      message({.delayed = {1e-7}, .retardation_times = {0.01}}),
      "adhesion.strength must be given in Pa, or the range in m, for a material without instantaneous compliance, got "
      "none, which is an infinite strength");
  EXPECT_EQ(
      message(two_times()),
      "adhesion.strength must be given in Pa, or the range in m, for a material with retardation times from 0.001 to 2 "
      "s, because the work of separation depends on it, got none, which is an infinite strength");
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
