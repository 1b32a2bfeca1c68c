// Creep spectrum and step weights: the parts of transient rolling that Python cannot access.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "base/dense_solvers.hpp"
#include "cases.hpp"
#include "influence/table_sums.hpp"
#include "materials/creep_spectrum.hpp"
#include "modal/layered_body.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/time_step.hpp"
#include "transient/viscoelastic_body.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {
namespace {

constexpr TimeRange kRange{.shortest = 1e-5, .longest = 1e5};

/// Largest relative error of mu*(0) / mu*(i omega) over frequencies.
double error_of(const CreepSpectrum& spectrum, const ShearModulus& modulus, double low, double high) {
  double largest = 0.0;
  const double relaxed = complex_modulus(modulus, std::vector{0.0}).front().real();
  for (int i = 0; i <= 60; ++i) {
    const double omega = low * std::pow(high / low, i / 60.0);
    std::complex<double> compliance = spectrum.instantaneous;
    for (std::size_t j = 0; j < spectrum.size(); ++j) {
      compliance += spectrum.weights[j] / std::complex<double>(1.0, omega * spectrum.retardation_times[j]);
    }
    const auto exact = relaxed / complex_modulus(modulus, std::vector{omega}).front();
    largest = std::max(largest, std::abs(compliance / exact - 1.0));
  }
  return largest;
}

TEST(CreepSpectrum, OfAStandardLinearSolidHasItsClosedForm) {
  const CreepSpectrum spectrum = creep_spectrum(cases::rubber(), kRange);
  ASSERT_EQ(spectrum.size(), 1U);
  EXPECT_NEAR(spectrum.instantaneous, 0.5, 1e-15);
  EXPECT_NEAR(spectrum.weights[0], 0.5, 1e-14);
  EXPECT_NEAR(spectrum.retardation_times[0], 0.25, 1e-14);  // tau G_0 / G_inf
}

TEST(CreepSpectrum, OfManyDecadesIsExact) {
  Prony series{.instantaneous_modulus = 1e9, .weights = {}, .relaxation_times = {}};
  for (int k = 0; k < 24; ++k) {
    series.weights.push_back(k < 12 ? 0.08 : 0.003);
    series.relaxation_times.push_back(std::pow(10.0, 0.5 * k - 6.0));
  }
  const CreepSpectrum spectrum = creep_spectrum(series, kRange);
  ASSERT_EQ(spectrum.size(), 24U);
  double sum = spectrum.instantaneous;
  for (std::size_t j = 0; j < 24; ++j) {
    EXPECT_GT(spectrum.weights[j], 0.0);
    EXPECT_GT(spectrum.retardation_times[j], series.relaxation_times[j]);  // the two sets of times interlace
    sum += spectrum.weights[j];
  }
  EXPECT_NEAR(sum, 1.0, 1e-11);
  EXPECT_LT(error_of(spectrum, series, 1e-8, 1e8), 1e-11);
}

TEST(CreepSpectrum, OfNearlyEqualRelaxationTimesIsAccurate) {
  const Prony series{.instantaneous_modulus = 6e6,
                     .weights = {0.2, 0.3, 0.1},
                     .relaxation_times = {0.125, 0.125 * (1.0 + 1e-9), 0.125}};
  const CreepSpectrum spectrum = creep_spectrum(series, kRange);
  ASSERT_EQ(spectrum.size(), 2U);  // equal times are merged
  EXPECT_LT(error_of(spectrum, series, 1e-3, 1e3), 1e-8);
}

TEST(CreepSpectrum, OfAFractionalZenerSolidConverges) {
  for (const double order : {0.3, 0.5, 0.7, 0.9, 0.97}) {
    const FractionalZener solid{6e6, 3e6, 0.125, order};
    const CreepSpectrum spectrum = creep_spectrum(solid, kRange);
    // Retardation outside the range is treated as instantaneous, or as that of the slowest term.
    EXPECT_LT(error_of(spectrum, solid, 1e-4, 1e4), 1e-3) << order;
    EXPECT_LT(spectrum.size(), 70U) << order;
  }
}

TEST(CreepSpectrum, OfAKelvinVoigtSolidHasNoInstantaneousCompliance) {
  const CreepSpectrum spectrum = creep_spectrum(KelvinVoigt{1e6, 1e4}, kRange);
  EXPECT_EQ(spectrum.instantaneous, 0.0);
  EXPECT_NEAR(spectrum.retardation_times.at(0), 1e-2, 1e-16);
}

TEST(CreepSpectrum, FitsATableAndEstimatesTheError) {
  // Table of the fractional solid over nine decades; docs/theory/transient.md. With three retardation times per decade,
  // a fit of the exact modulus has an error of 6.5e-5; the table has a larger one because its interpolation has kinks.
  const FractionalZener solid{6e6, 3e6, 0.125, 0.5};
  MasterCurve curve{.frequency = {0.0}, .storage = {3e6}, .loss = {0.0}, .extrapolation = Extrapolation::hold};
  for (int i = 0; i <= 180; ++i) {
    const double omega = std::pow(10.0, i / 20.0 - 4.5);
    const auto value = complex_modulus(solid, std::vector{omega}).front();
    curve.frequency.push_back(omega);
    curve.storage.push_back(value.real());
    curve.loss.push_back(value.imag());
  }
  const CreepSpectrum spectrum = creep_spectrum(curve, {.shortest = 1e-2, .longest = 1e2});
  EXPECT_LT(spectrum.error, 1e-3);
  EXPECT_GT(spectrum.error, 0.0);
  EXPECT_LT(error_of(spectrum, solid, 1e-2, 1e2), 2e-3);
}

TEST(NonnegativeLeastSquares, SetsNegativeUnknownsToZero) {
  Eigen::MatrixXd matrix(3, 2);
  matrix << 1.0, 1.0, 1.0, 2.0, 1.0, 3.0;
  const Eigen::VectorXd falling = nonnegative_least_squares(matrix, Eigen::Vector3d(3.0, 2.0, 1.0));
  EXPECT_EQ(falling[1], 0.0);  // the slope of the free fit is -1
  EXPECT_NEAR(falling[0], 2.0, 1e-14);
  const Eigen::VectorXd rising = nonnegative_least_squares(matrix, Eigen::Vector3d(2.0, 3.0, 4.0));
  EXPECT_NEAR(rising[0], 1.0, 1e-12);
  EXPECT_NEAR(rising[1], 1.0, 1e-12);
}

TEST(TimeStep, SeriesAgreesWithTheClosedForm) {
  const CreepSpectrum one{.instantaneous = 0.25, .weights = {0.75}, .retardation_times = {1.0}};
  const TimeStep below(one, 0.999e-3);
  const TimeStep above(one, 1.001e-3);
  const auto ratio = [&](double TimeStep::Term::* coefficient) {
    return above.terms[0].*coefficient / below.terms[0].*coefficient;
  };
  // For such short steps, each coefficient is proportional to the step, with a correction of the order of the step.
  EXPECT_NEAR(ratio(&TimeStep::Term::on_new), 1.001 / 0.999, 1e-6);
  EXPECT_NEAR(ratio(&TimeStep::Term::lost_change), 1.001 / 0.999, 3e-6);
  const TimeStep jump(one, 0.0);
  EXPECT_EQ(jump.compliance, 0.25);
  EXPECT_EQ(jump.terms[0].lost_state, 0.0);
  const TimeStep long_step(one, 1e9);
  EXPECT_NEAR(long_step.compliance, 1.0, 1e-8);
}

TEST(StepChoice, StepsGrowAtStandstillAndFollowTheSpacing) {
  const StepChoice choice(0.01, 4, 0.25);
  EXPECT_EQ(choice.fractions({.duration = 0.1, .turn = 0.25, .relative_load = 0.0}, 0.001).size(), 100U);
  const auto stand = choice.fractions({.duration = 1000.0, .turn = 0.0, .relative_load = 0.0}, 0.01);
  EXPECT_LT(stand.size(), 130U);
  EXPECT_EQ(stand.back(), 1.0);
  EXPECT_EQ(StepChoice(0.01, std::nullopt, 0.25).fractions({.duration = 1.0, .turn = 9.0, .relative_load = 0.0}, 0.0),
            std::vector{1.0});
}

/// The contact gains nodes one by one and in groups, and loses nodes. Nodes in the middle do not move laterally.
TEST(ContactStiffness, IsTheInverseOfTheComplianceOfItsNodes) {
  const Observer silent;
  Watch watch(silent);
  const Mesh mesh{.nodes_per_revolution = 200};
  const CoatingSum sum(layered_body(std::get<CoatedSphere>(with_relaxed_moduli(RollingBody(cases::paper_sphere())))),
                       1.0, mesh, 1, watch);
  const MirroredTables tables(sum, {.components = 3, .half_nodes = 5, .ring = 200, .most = 100}, 1, watch);
  const auto nodes = [](Eigen::Index first, Eigen::Index last) {
    std::vector<Eigen::Index> range;
    for (Eigen::Index node = first; node < last; ++node) range.push_back(node);
    return range;
  };
  const Axes own;  // has no effect for a single body
  const StepOperator surface({{1.0, &tables, &own}}, [] {});
  ContactStiffness stiffness;
  EXPECT_TRUE(stiffness.cover(surface, nodes(10, 14)));
  EXPECT_TRUE(stiffness.cover(surface, nodes(10, 15)));
  EXPECT_TRUE(stiffness.cover(surface, nodes(7, 50)));
  EXPECT_FALSE(stiffness.cover(surface, nodes(12, 49)));
  EXPECT_EQ(stiffness.nodes().size(), 43U);
  EXPECT_EQ(stiffness.matrix(), stiffness.matrix().transpose().eval()) << "the solver uses columns in place of rows";
  const auto largest_error = [&] {
    Eigen::MatrixXd product = stiffness.matrix() * tables.compliance(stiffness.nodes(), stiffness.nodes());
    for (Eigen::Index i = 0; i < product.rows(); ++i) {
      const bool is_fixed = i % 3 == 2 && stiffness.nodes()[static_cast<std::size_t>(i / 3)] % 5 == 0;
      EXPECT_EQ(product(i, i) == 0.0, is_fixed);
      product(i, i) -= is_fixed ? 0.0 : 1.0;
    }
    return product.cwiseAbs().maxCoeff();
  };
  // The tolerance is the round-off times the condition number of an incompressible coating.
  EXPECT_LT(largest_error(), 1e-11);
  EXPECT_TRUE(stiffness.cover(surface, nodes(20, 30)));
  EXPECT_EQ(stiffness.nodes(), nodes(20, 30));
  EXPECT_LT(largest_error(), 1e-11);
}

/// Long products are computed in batches of offsets along the path, between which they can be canceled.
TEST(MirroredTables, LongProductsPollAndAgreeWithTheCompliance) {
  const Observer silent;
  Watch watch(silent);
  const Mesh mesh{.nodes_per_revolution = 1000};
  const CoatingSum sum(layered_body(std::get<CoatedSphere>(with_relaxed_moduli(RollingBody(cases::paper_sphere())))),
                       1.0, mesh, 1, watch);
  constexpr Eigen::Index kHalfNodes = 150;
  constexpr Eigen::Index kRows = 45;
  const MirroredTables tables(sum, {.components = 3, .half_nodes = kHalfNodes, .ring = 1000, .most = 40}, 1, watch);
  const std::vector<Eigen::Index> loaded{3 * kHalfNodes, 20 * kHalfNodes + 77, 40 * kHalfNodes + 149};
  const std::vector<Eigen::Index> displaced{5, 3 * kHalfNodes, 12 * kHalfNodes + 60, 44 * kHalfNodes + 149};
  HalfField loads = HalfField::Zero(3 * kHalfNodes, kRows);
  Eigen::VectorXd forces(9);
  for (Eigen::Index i = 0; i < 9; ++i) {
    forces[i] = 1.0 + static_cast<double>(i);
    const Eigen::Index node = loaded[static_cast<std::size_t>(i / 3)];
    loads(i % 3 * kHalfNodes + node % kHalfNodes, node / kHalfNodes) = forces[i];
  }
  int polled = 0;
  const HalfField found = tables.displacement(loads, 3, 40, [&polled] { ++polled; });
  // One block of at most 64 rows of loads has 41 offsets, in six batches of 7.
  EXPECT_GE(polled, 6);
  const Eigen::VectorXd expected = tables.compliance(displaced, loaded) * forces;
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    const Eigen::Index node = displaced[static_cast<std::size_t>(i / 3)];
    EXPECT_NEAR(found(i % 3 * kHalfNodes + node % kHalfNodes, node / kHalfNodes), expected[i],
                1e-13 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(RollingHistory, ResultsDoNotDependOnThreads) {
  const Mesh mesh{.nodes_per_revolution = 120};
  std::vector<double> torques;
  for (const int threads : {1, 3}) {
    RollingHistory history(cases::paper_sphere(), 100.0, Start::undeformed, {.mesh = mesh, .threads = threads});
    torques.push_back(history.advance(0.1, 0.25, 120.0).resisting_torque);
  }
  EXPECT_EQ(torques[0], torques[1]);
}

TEST(RollingHistory, AFailedStepLeavesTheHistoryUnchanged) {
  RollingHistory history(cases::paper_sphere(), 100.0, Start::relaxed, {.mesh = Mesh{.nodes_per_revolution = 100}});
  history.advance(0.1, 0.1, 100.0);
  const RollingInstant before = history.current();
  EXPECT_THROW(history.advance(0.2, 0.2, 1e7), std::invalid_argument);
  EXPECT_EQ(history.current().time, before.time);
  EXPECT_EQ(history.current().load, before.load);
  const Observer stopping{.cancelled = [] { return true; }, .progress = {}};
  EXPECT_THROW(history.advance(1000.0, 3000.0, 100.0, std::nullopt, stopping), Canceled);
  EXPECT_EQ(history.current().time, before.time);
}

}  // namespace
}  // namespace viscoroll::detail
