// Layers with different relaxation functions at common retardation times, compared with the modes of each order.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>
#include <utility>
#include <vector>

#include "base/dense_solvers.hpp"
#include "creep/layer_spectrum.hpp"
#include "creep/order_weights.hpp"
#include "influence/table_sums.hpp"
#include "modal/layered_body.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll::detail {
namespace {

constexpr TimeRange kRange{.shortest = 1e-4, .longest = 1e4};
constexpr double kRadius = 0.021;

/// Layer of a mat on a rigid base; a list of layers is ordered outwards.
struct Material {
  double thickness;
  double poisson_ratio;
  Prony series;
};

Material solid(double instantaneous, double relaxed, double time, double poisson_ratio = 0.5) {
  return {
      .thickness = 5e-4, .poisson_ratio = poisson_ratio, .series = standard_linear_solid(instantaneous, relaxed, time)};
}

/// A layer of 0.5 mm with 6 and 3 MPa and 0.125 s, on a layer of 0.5 mm with 4 and 1 MPa and 0.02 s.
std::vector<Material> two_solids() { return {solid(4e6, 1e6, 0.02), solid(6e6, 3e6, 0.125)}; }

std::vector<Material> three_solids() {
  return {solid(2e6, 1.5e6, 1e-3, 0.3), solid(4e6, 1e6, 0.02), solid(6e6, 3e6, 0.125, 0.45)};
}

Material broad(double first_time, double modulus) {
  Prony series{.instantaneous_modulus = modulus, .weights = {}, .relaxation_times = {}};
  for (int k = 0; k < 6; ++k) {
    series.weights.push_back(0.13);
    series.relaxation_times.push_back(first_time * std::pow(10.0, k));
  }
  return {.thickness = 5e-4, .poisson_ratio = 0.5, .series = series};
}

std::vector<Material> two_broad() { return {broad(3e-4, 4e6), broad(1e-4, 6e6)}; }

LayeredBody mat(const std::vector<Material>& materials) {
  CoatedPlane plane;
  for (const Material& material : materials) {
    plane.layers.push_back({.thickness = material.thickness,
                            .shear_modulus = material.series,
                            .poisson_ratio = material.poisson_ratio,
                            .bulk_modulus = {},
                            .density = 0.0});
  }
  return layered_body(plane, kRadius);
}

double order_of(double wave_number) { return wave_number * kRadius; }

/// Modes of one order in plane strain.
struct Modes {
  double instantaneous;
  Eigen::VectorXd times;
  Eigen::VectorXd weights;
};

/// Stiffness of a layer of modulus 1 between its faces, from its transition matrix: u, v inside, then u, v outside.
Eigen::Matrix4d stiffness(const Material& material, double k) {
  const double b = (1.0 - 2.0 * material.poisson_ratio) / (2.0 * (1.0 - material.poisson_ratio));
  const double a = 1.0 - 2.0 * b;
  Eigen::Matrix4d rates;    // of u, v, s, tau per k y, docs/theory/planes-and-pairs.md
  rates << 0.0, a, b, 0.0,  //
      -1.0, 0.0, 0.0, 1.0,  //
      0.0, 0.0, 0.0, 1.0,   //
      0.0, 4.0 * (1.0 - b), -a, 0.0;
  const Eigen::Matrix4d through = (rates * (k * material.thickness)).exp();
  const Eigen::Matrix2d inverse = through.topRightCorner<2, 2>().inverse();
  Eigen::Matrix4d result;
  result.topLeftCorner<2, 2>() = inverse * through.topLeftCorner<2, 2>();
  result.topRightCorner<2, 2>() = -inverse;
  result.bottomRightCorner<2, 2>() = through.bottomRightCorner<2, 2>() * inverse;
  result.bottomLeftCorner<2, 2>() = result.topRightCorner<2, 2>().transpose();
  return k * result;
}

/// Eigenvalues of the symmetric problem of the layers' internal variables: with A_l = R_l R_l^T, V = [sqrt(G_l g_lk)
/// R_l] and M_0 = sum G_l A_l, C = e M_0^-1 e + b (I - W + s T)^-1 b, b = V^T M_0^-1 e, W = V^T M_0^-1 V.
Modes modes_of(const std::vector<Material>& materials, double k) {
  const auto size = static_cast<Eigen::Index>(2 * materials.size());
  Eigen::MatrixXd at_once = Eigen::MatrixXd::Zero(size, size);
  std::vector<Eigen::VectorXd> columns;
  std::vector<double> times;
  for (std::size_t l = 0; l < materials.size(); ++l) {
    // Spread the layer's matrix over its interfaces; the base is fixed.
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(size, size);
    const auto outer = static_cast<Eigen::Index>(2 * l);
    const Eigen::Matrix4d own = stiffness(materials[l], k);
    if (l > 0) {
      spread.block<4, 4>(outer - 2, outer - 2) = own;
    } else {
      spread.block<2, 2>(0, 0) = own.bottomRightCorner<2, 2>();
    }
    const Prony& series = materials[l].series;
    at_once += series.instantaneous_modulus * spread;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> roots(0.5 * (spread + spread.transpose()));
    for (Eigen::Index i = 0; i < size; ++i) {
      const double value = roots.eigenvalues()[i];
      if (value < 1e-12 * roots.eigenvalues()[size - 1]) continue;
      for (std::size_t g = 0; g < series.weights.size(); ++g) {
        columns.emplace_back(std::sqrt(series.instantaneous_modulus * series.weights[g] * value) *
                             roots.eigenvectors().col(i));
        times.push_back(series.relaxation_times[g]);
      }
    }
  }
  Eigen::MatrixXd internal(size, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) internal.col(static_cast<Eigen::Index>(i)) = columns[i];
  const Eigen::VectorXd slowness =
      Eigen::Map<const Eigen::VectorXd>(times.data(), internal.cols()).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd short_time = dense_inverse(at_once);
  const Eigen::MatrixXd moved = short_time * internal;
  const Eigen::MatrixXd stiff =
      Eigen::MatrixXd::Identity(internal.cols(), internal.cols()) - internal.transpose() * moved;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> roots(slowness.asDiagonal() * stiff * slowness.asDiagonal());
  const Eigen::VectorXd amplitudes =
      roots.eigenvectors().transpose() * (slowness.asDiagonal() * moved.row(size - 2).transpose());
  Modes modes{
      .instantaneous = short_time(size - 2, size - 2), .times = roots.eigenvalues().cwiseInverse(), .weights = {}};
  modes.weights = modes.times.cwiseProduct(amplitudes.cwiseAbs2());
  return modes;
}

/// Weights of an exact spectrum at the common times.
Eigen::VectorXd shared_out(const Modes& modes, const std::vector<double>& times) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(times.size()));
  for (Eigen::Index m = 0; m < modes.times.size(); ++m) {
    weights += modes.weights[m] * shares(times, modes.times[m]).real();
  }
  return weights;
}

// For larger ones, transition matrices lose their digits.
constexpr std::array kWaveNumbersByThickness{0.1, 0.5, 2.0, 5.0};

TEST(LayerSpectrum, WeightsAgreeWithTheModesOfEachOrder) {
  for (const auto& materials : {two_solids(), three_solids(), two_broad()}) {
    const LayerSpectrum spectrum(mat(materials), kRange, 1e-4);
    for (const double kh : kWaveNumbersByThickness) {
      const double k = kh / 1e-3;
      const SurfaceOrder order{.m = order_of(k), .n = 0.0};
      const auto weights = spectrum.weights_of(std::span(&order, 1)).front();
      const Modes modes = modes_of(materials, k);
      const Eigen::VectorXd expected = shared_out(modes, spectrum.retardation_times());
      const double relaxed = modes.instantaneous + modes.weights.sum();
      EXPECT_NEAR(weights[0](0, 0), modes.instantaneous, 1e-10 * relaxed);
      for (Eigen::Index j = 0; j < expected.size(); ++j) {
        // The eigenproblem of 36 modes over five decades is accurate to ten digits.
        EXPECT_NEAR(weights[static_cast<std::size_t>(j) + 1](0, 0), expected[j], 1e-9 * relaxed) << kh << ' ' << j;
      }
    }
  }
}

TEST(RetardationIntervals, ContainEveryModeOfEveryOrder) {
  constexpr double kRoundOff = 1e-6;  // accuracy of the times from the eigenproblem
  for (const auto& materials : {two_solids(), three_solids(), two_broad()}) {
    const auto moduli = creep_functions(mat(materials).layers, kRange);
    const auto intervals = retardation_intervals(moduli, false);
    for (const double kh : kWaveNumbersByThickness) {
      for (const double time : modes_of(materials, kh / 1e-3).times) {
        EXPECT_TRUE(std::ranges::any_of(intervals,
                                        [time](const TimeRange& interval) {
                                          return time > interval.shortest * (1.0 - kRoundOff) &&
                                                 time < interval.longest * (1.0 + kRoundOff);
                                        }))
            << kh << ' ' << time;
      }
    }
  }
}

TEST(RetardationIntervals, LieBetweenTheTimesOfEachMaterial) {
  const auto moduli = creep_functions(mat(two_solids()).layers, kRange);
  const auto intervals = retardation_intervals(moduli, false);
  ASSERT_EQ(intervals.size(), 2U);  // from tau to tau G_0 / G_inf
  EXPECT_NEAR(intervals[0].shortest, 0.02, 1e-14);
  EXPECT_NEAR(intervals[0].longest, 0.08, 1e-14);
  EXPECT_NEAR(intervals[1].shortest, 0.125, 1e-14);
  EXPECT_NEAR(intervals[1].longest, 0.25, 1e-14);
}

TEST(LayerSpectrum, MeetsItsToleranceWithFewTimes) {
  struct Expected {
    std::vector<Material> materials;
    double tolerance;
    std::size_t times;
  };
  for (const auto& [materials, tolerance, times] : std::vector<Expected>{{two_solids(), 1e-2, 6},
                                                                         {two_solids(), 1e-3, 8},
                                                                         {two_solids(), 1e-4, 10},
                                                                         {three_solids(), 1e-3, 11},
                                                                         {two_broad(), 1e-3, 25},
                                                                         {two_broad(), 1e-4, 28}}) {
    const LayerSpectrum spectrum(mat(materials), kRange, tolerance);
    EXPECT_EQ(spectrum.retardation_times().size(), times);
    const double error = spectrum.error(kRange);
    EXPECT_LT(error, tolerance);
    EXPECT_GT(error, 1e-3 * tolerance);  // otherwise fewer times would suffice
  }
}

TEST(LayerSpectrum, MeetsItsToleranceOnBallsCylindersAndElasticLayers) {
  constexpr double kTolerance = 1e-3;
  CoatedSphere ball{.core_radius = 0.02, .layers = {}};
  for (const Material& material : two_solids()) {
    ball.layers.push_back({.thickness = material.thickness,
                           .shear_modulus = material.series,
                           .poisson_ratio = material.poisson_ratio,
                           .bulk_modulus = {},
                           .density = 1000.0});
  }
  EXPECT_LT(LayerSpectrum(layered_body(ball), kRange, kTolerance).error(kRange), kTolerance);
  ball.inner_boundary = InnerBoundary::hollow;
  EXPECT_LT(LayerSpectrum(layered_body(ball), kRange, kTolerance).error(kRange), kTolerance);
  const CoatedCylinder roller{.core_radius = 0.02, .layers = ball.layers};
  EXPECT_LT(LayerSpectrum(layered_body(roller), kRange, kTolerance).error(kRange), kTolerance);
  CoatedPlane on_elastic{.layers = ball.layers,
                         .base = HalfSpace{.shear_modulus = Elastic{2e7}, .poisson_ratio = 0.3, .bulk_modulus = {}}};
  on_elastic.layers[0].shear_modulus = Elastic{3e6};
  EXPECT_LT(LayerSpectrum(layered_body(on_elastic, kRadius), kRange, kTolerance).error(kRange), kTolerance);
}

TEST(LayerSpectrum, SupportsBulkModuli) {
  constexpr double kTolerance = 1e-3;
  auto materials = two_solids();
  LayeredBody body = mat(materials);
  for (Layer& layer : body.layers) {
    layer.poisson_ratio.reset();
    layer.bulk_modulus = 1e7;
  }
  EXPECT_LT(LayerSpectrum(body, kRange, kTolerance).error(kRange), kTolerance);
  body.layers.pop_back();  // with a bulk modulus, the creep of one layer depends on the order
  body.boundaries.pop_back();
  EXPECT_LT(LayerSpectrum(body, kRange, kTolerance).error(kRange), kTolerance);
}

TEST(LayerSpectrum, OfMeasuredModuliHasTheErrorOfTheirFits) {
  LayeredBody body = mat(two_solids());
  body.layers[0].shear_modulus =
      FractionalZener{.instantaneous_modulus = 6e6, .relaxed_modulus = 1e6, .relaxation_time = 0.02, .order = 0.6};
  constexpr TimeRange kSeconds{.shortest = 1e-3, .longest = 1e2};
  EXPECT_LT(LayerSpectrum(body, kSeconds, 1e-3).error(kSeconds), 1e-3);
  MasterCurve curve{.frequency = {0.0}, .storage = {1e6}, .loss = {0.0}, .extrapolation = Extrapolation::error};
  for (int i = 0; i <= 60; ++i) {
    const double omega = std::pow(10.0, -3.0 + 0.1 * i);
    curve.frequency.push_back(omega);
    const auto modulus = complex_modulus(body.layers[0].shear_modulus, std::array{omega}).front();
    curve.storage.push_back(modulus.real());
    curve.loss.push_back(modulus.imag());
  }
  body.layers[0].shear_modulus = curve;
  EXPECT_LT(LayerSpectrum(body, kSeconds, 1e-3).error(kSeconds), 5e-3);  // error of the fit of the table
}

TEST(LayerSpectrum, IsExactInTheRelaxedAndInstantaneousLimits) {
  const auto materials = three_solids();
  const LayeredBody body = mat(materials);
  const LayerSpectrum spectrum(body, kRange, 1e-2);
  for (const SurfaceOrder& order : compared_orders(body)) {
    const auto weights = spectrum.weights_of(std::span(&order, 1)).front();
    // At this frequency [rad/s], relaxation has no effect to ten digits.
    constexpr double kAtOnce = 1e12;
    for (const double omega : {0.0, kAtOnce}) {
      const Eigen::Matrix3cd exact = compliance_at(body, order, omega);
      const Eigen::Matrix3cd ours = spectrum.compliance(weights, omega);
      EXPECT_LT((ours - exact).cwiseAbs().maxCoeff(), 1e-9 * exact.cwiseAbs().maxCoeff()) << order.m;
    }
  }
}

TEST(LayerSpectrum, OfLayersWithOneRelaxationFunctionIsThatOfTheMaterial) {
  LayeredBody body = mat({solid(4e6, 1e6, 0.02), solid(8e6, 2e6, 0.02)});  // same relaxation function
  const LayerSpectrum spectrum(body, kRange, 1e-3);
  ASSERT_EQ(spectrum.retardation_times().size(), 1U);
  EXPECT_NEAR(spectrum.retardation_times()[0], 0.08, 1e-14);
  for (const SurfaceOrder& order : compared_orders(body)) {
    const auto weights = spectrum.weights_of(std::span(&order, 1)).front();
    EXPECT_LT((weights[1] - 3.0 * weights[0]).cwiseAbs().maxCoeff(), 1e-12 * weights[1].cwiseAbs().maxCoeff());
  }
}

TEST(LayerSpectrum, OfShortWavesIsThatOfTheOutermostLayer) {
  const auto materials = two_solids();
  const LayerSpectrum spectrum(mat(materials), kRange, 1e-3);
  const SurfaceOrder order{.m = order_of(25.0 / 5e-4), .n = 0.0};  // e^-50 of a wave reaches the layer below
  const auto weights = spectrum.weights_of(std::span(&order, 1)).front();
  const auto& times = spectrum.retardation_times();
  for (std::size_t j = 0; j < times.size(); ++j) {
    const double own = std::abs(times[j] / 0.25 - 1.0) < 1e-12 ? 1.0 : 0.0;  // J_j / J_0 of 6/3 MPa, 0.125 s
    EXPECT_NEAR(weights[j + 1](0, 0), own * weights[0](0, 0), 1e-11 * weights[0](0, 0));
  }
}

/// Random layers with one to four terms each.
std::vector<Material> random_materials(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Material> materials(2 + random() % 2);
  for (Material& material : materials) {
    const std::size_t terms = 1 + random() % 4;
    Prony series{
        .instantaneous_modulus = std::pow(10.0, 5.5 + 2.0 * uniform(random)), .weights = {}, .relaxation_times = {}};
    for (std::size_t g = 0; g < terms; ++g) {
      series.weights.push_back((0.2 + 0.7 * uniform(random)) / static_cast<double>(terms));
      series.relaxation_times.push_back(std::pow(10.0, -3.0 + 4.0 * uniform(random)));
    }
    material = {.thickness = 2e-4 + 1e-3 * uniform(random), .poisson_ratio = 0.5 * uniform(random), .series = series};
  }
  return materials;
}

TEST(LayerSpectrum, OfRandomLayersDissipatesAtEveryOrderAndFrequency) {
  std::mt19937 random(27);
  constexpr double kTolerance = 1e-3;
  for (int stack = 0; stack < 100; ++stack) {
    const LayeredBody body = mat(random_materials(random));
    const LayerSpectrum spectrum(body, kRange, kTolerance);
    const auto orders = compared_orders(body);
    const auto weights = spectrum.weights_of(orders);
    for (const auto& of_order : weights) {
      for (const double omega : compared_frequencies(body.layers, kRange)) {
        const Eigen::Matrix3d lost = -spectrum.compliance(of_order, omega).imag();
        // Any traction: normal, and shear along k and across it.
        const double least =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(lost, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
        ASSERT_GT(least, 0.0) << stack << ' ' << omega;
      }
    }
    ASSERT_LT(spectrum.error(kRange), kTolerance) << stack;
  }
}

constexpr std::array kAllEntries{Entry::rr,     Entry::rphi,     Entry::rtheta,
                                 Entry::phiphi, Entry::phitheta, Entry::thetatheta};

/// Row and column of an entry in the compliance.
std::pair<Eigen::Index, Eigen::Index> place_of(Entry entry) {
  constexpr std::array<std::pair<Eigen::Index, Eigen::Index>, kEntries> kPlaces{
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  return kPlaces[static_cast<std::size_t>(entry)];
}

std::vector<TableRequest> all_entries() {
  std::vector<TableRequest> requests;
  requests.reserve(kAllEntries.size());
  for (const Entry entry : kAllEntries) requests.push_back({.entry = entry});
  return requests;
}

/// Body of elastic layers with the instantaneous moduli of `body`.
LayeredBody at_once(LayeredBody body) {
  for (Layer& layer : body.layers) {
    layer.shear_modulus = Elastic{std::get<Prony>(layer.shear_modulus).instantaneous_modulus};
  }
  return body;
}

double largest_difference(const Table& a, const Table& b, int phi_reach, int theta_reach) {
  double largest = 0.0;
  for (int j = -phi_reach; j <= phi_reach; ++j) {
    for (int l = -theta_reach; l <= theta_reach; ++l) largest = std::max(largest, std::abs(a(j, l) - b(j, l)));
  }
  return largest;
}

/// Return the sum of the tables of all weights.
std::vector<Table> at_rest(const std::vector<std::vector<Table>>& tables, int phi_reach, int theta_reach) {
  std::vector<Table> sums = tables.front();
  for (std::size_t w = 1; w < tables.size(); ++w) {
    for (std::size_t e = 0; e < sums.size(); ++e) {
      for (int j = -phi_reach; j <= phi_reach; ++j) {
        const auto row = sums[e].row(j);
        for (int l = 0; l <= theta_reach; ++l) row[static_cast<std::size_t>(l)] += tables[w][e](j, l);
      }
    }
  }
  return sums;
}

TEST(Weights, TablesAgreeWithElasticLayersInBothLimits) {
  constexpr int kPhiReach = 20;
  constexpr int kThetaReach = 10;
  const Mesh mesh{.nodes_per_revolution = 200};
  const Observer silent;
  Watch watch(silent);
  CoatedSphere ball{.core_radius = 0.02, .layers = mat(two_solids()).layers};
  for (const LayeredBody& body : {layered_body(ball), mat(two_solids())}) {
    const LayerSpectrum spectrum(body, kRange, 1e-2);
    std::vector<std::vector<Table>> tables;
    for (const auto& sum : weights_under_spot(spectrum, mesh, 1, watch)) {
      tables.push_back(sum->tables(all_entries(), kPhiReach, kThetaReach, 1, watch));
    }
    const auto rest = CoatingSum(spectrum.body_at_rest(), 1.0, mesh, 1, watch)
                          .tables(all_entries(), kPhiReach, kThetaReach, 1, watch);
    const auto once =
        CoatingSum(at_once(body), 1.0, mesh, 1, watch).tables(all_entries(), kPhiReach, kThetaReach, 1, watch);
    const auto sums = at_rest(tables, kPhiReach, kThetaReach);
    const double center = rest[0](0, 0);
    for (std::size_t e = 0; e < rest.size(); ++e) {
      EXPECT_LT(largest_difference(sums[e], rest[e], kPhiReach, kThetaReach), 1e-12 * center) << e;
      EXPECT_LT(largest_difference(tables[0][e], once[e], kPhiReach, kThetaReach), 1e-12 * center) << e;
    }
  }
}

TEST(Weights, OfAWheelAgreeWithItsOrders) {
  constexpr double kHighest = 300.0;
  const CoatedWheel wheel{.core_radius = 0.02, .layers = mat(two_solids()).layers, .width = 0.01, .crown_radius = 0.1};
  const LayerSpectrum spectrum(layered_body(wheel), kRange, 1e-2);
  const Observer silent;
  Watch watch(silent);
  const auto weights = order_weights(spectrum, {0.0, kHighest}, kHighest, 1, watch);
  const Eigen::ArrayXd n{{0.0, 0.3, 3.0, 40.0, 290.0}};
  for (const double m : {0.0, 1.0, 2.7, 17.0, 150.0, 299.0}) {
    for (std::size_t w = 0; w < spectrum.weights(); ++w) {
      OrderSeries series;
      weights->series(w, m, kHighest, series);
      const OrderValues values(m, n, series);
      for (const Entry entry : kAllEntries) {
        Eigen::ArrayXcd found;
        values.evaluate(entry, found);
        for (Eigen::Index i = 0; i < n.size(); ++i) {
          const SurfaceOrder order{.m = m, .n = n[i]};
          const auto exact = spectrum.weights_of(std::span(&order, 1)).front();
          const Eigen::Matrix3d at_rest = std::accumulate(exact.begin(), exact.end(), Eigen::Matrix3d::Zero().eval());
          const Eigen::Matrix3cd physical = to_physical<double>(exact[w]);
          const auto [row, column] = place_of(entry);
          const double size = std::sqrt(at_rest(row, row) * at_rest(column, column));
          EXPECT_LE(std::abs(found[i] - physical(row, column)), 1e-9 * size)
              << m << ' ' << n[i] << ' ' << w << ' ' << static_cast<int>(entry);
        }
      }
    }
  }
}

TEST(Weights, TablesOfALineContactAgreeWithElasticLayersInBothLimits) {
  constexpr int kReach = 40;
  const Mesh mesh{.nodes_per_revolution = 400};
  const Observer silent;
  Watch watch(silent);
  const CoatedCylinder roller{.core_radius = 0.02, .layers = mat(two_solids()).layers};
  const LayeredBody body = layered_body(roller);
  const LayerSpectrum spectrum(body, kRange, 1e-2);
  std::vector<std::vector<Table>> tables;
  for (const auto& sum : weights_under_line(spectrum, mesh, 1, watch)) {
    tables.push_back(sum->tables({{.entry = Entry::rr}}, kReach, 0, 1, watch));
  }
  const auto elastic = [&](const LayeredBody& layers) {
    auto bands = phi_bands(layers, 1.0, mesh);
    const HarmonicBody harmonics(layers, 1.0, all_orders(bands));
    return LineSum(std::move(bands), harmonics, mesh, 1, watch).tables({{.entry = Entry::rr}}, kReach, 0, 1, watch);
  };
  const auto rest = elastic(spectrum.body_at_rest());
  const auto sums = at_rest(tables, kReach, 0);
  const double center = rest[0](0, 0);
  EXPECT_LT(largest_difference(sums[0], rest[0], kReach, 0), 1e-12 * center);
  EXPECT_LT(largest_difference(tables[0][0], elastic(at_once(body))[0], kReach, 0), 1e-12 * center);
}

}  // namespace
}  // namespace viscoroll::detail
