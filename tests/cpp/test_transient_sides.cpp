// Contribution of free sides to the tables of histories, and to the weights of dissimilar layers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "creep/free_sides.hpp"
#include "influence/side_influence.hpp"
#include "section/section_compliance.hpp"
#include "section/side_difference.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::ArrayXXd;
using Eigen::Index;

constexpr double kSpeed = 1.0;  // arbitrary for elastic layers
constexpr TimeRange kRange{.shortest = 1e-5, .longest = 1e5};

CoatedWheel wheel_of(std::vector<Layer> layers, double crown_radius) {
  return {.core_radius = 40e-3, .layers = std::move(layers), .width = 12e-3, .crown_radius = crown_radius};
}

CoatedWheel elastic_wheel() {
  return wheel_of({{.thickness = 6e-3, .shear_modulus = Elastic{2e6}, .poisson_ratio = 0.5},
                   {.thickness = 4e-3, .shear_modulus = Elastic{3e6}, .poisson_ratio = 0.45}},
                  0.2);
}

/// A stiff layer inside and a layer with other relaxation times and a bulk modulus outside.
CoatedWheel creeping_wheel() {
  return wheel_of({{.thickness = 6e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5},
                   {.thickness = 4e-3,
                    .shear_modulus = standard_linear_solid(4e6, 1e6, 0.02),
                    .poisson_ratio = {},
                    .bulk_modulus = 2e7}},
                  INFINITY);
}

constexpr SectionFineness kCoarse{.finest = 0.25, .growth = 0.5, .largest = 0.5};

/// Rows of nodes on a tread that ends outside them.
struct Rows {
  static constexpr Index kHalfNodes = 4;
  static constexpr int kReach = 6;
  static constexpr Index kCount = 5;
  static constexpr double kDistance = 1.5e-3;
  Index components;

  [[nodiscard]] RowShape shape() const {
    return {.components = components, .half_nodes = kHalfNodes, .ring = 400, .most = 200};
  }
  [[nodiscard]] Index height() const { return components * kHalfNodes; }
};

/// The same field on both sides, node by node, with a column for each component.
ArrayXXd unfolded(const HalfField& half, const Rows& rows) {
  constexpr Index kAcross = 2 * Rows::kHalfNodes - 1;
  const Eigen::ArrayXd weights = half_weights(Rows::kHalfNodes);
  ArrayXXd whole(kAcross * Rows::kCount, rows.components);
  for (Index row = 0; row < Rows::kCount; ++row) {
    for (Index k = 1 - Rows::kHalfNodes; k < Rows::kHalfNodes; ++k) {
      for (Index p = 0; p < rows.components; ++p) {
        const Index aside = std::abs(k);
        const double image = p == 2 && k < 0 ? -1.0 : 1.0;
        whole(kAcross * row + k + Rows::kHalfNodes - 1, p) =
            image * half(p * Rows::kHalfNodes + aside, row) / weights[aside];
      }
    }
  }
  return whole;
}

class SideInfluenceOfRows : public testing::TestWithParam<Index> {
 protected:
  const Rows rows_{.components = GetParam()};
  const Observer silent_;
  Watch watch_{silent_};
  std::mt19937 random_{5};

  [[nodiscard]] SideSum sum() {
    const CoatedWheel wheel = elastic_wheel();
    const LayeredBody layers = layered_body(wheel);
    const Eigen::ArrayXd samples = sampled_orders(wheel, kCoarse);
    const HarmonicBody sampled(layers, kSpeed, {samples.begin(), samples.end()});
    auto difference = std::make_shared<const SampledDifference>(
        SideDifference(wheel, rows_.components > 1, kCoarse).sampled(sampled, 1, watch_));
    const Mesh mesh{.nodes_per_revolution = 400};
    std::vector<OrderBand> bands = phi_bands(layers, kSpeed, mesh);
    const Eigen::VectorXcd smallest = inverse_outer_modulus(HarmonicBody(layers, kSpeed, all_orders(bands)));
    return {std::move(difference), std::move(bands), smallest, mesh};
  }

  /// Forces on all nodes; those in the middle have no theta component.
  [[nodiscard]] HalfField forces() {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    HalfField field = HalfField::NullaryExpr(rows_.height(), Rows::kCount, [&] { return any(random_); });
    if (rows_.components == 3) field.row(2 * Rows::kHalfNodes).setZero();
    return field;
  }
};

/// Work of one set of forces on the displacements of another. The product of steady rolling gathers forces over patches
/// and reads values at nodes; histories use the mean of both directions.
TEST_P(SideInfluenceOfRows, HasTheWorkOfTheSteadyProduct) {
  const SideSum sum = this->sum();
  const SideFactors factors = sum.factors({.phi_reach = Rows::kReach});
  const SampledDifference& difference = *sum.difference();
  const HalfField influence = side_influence(difference, factors, rows_.shape(), Rows::kDistance);
  ASSERT_EQ(influence.rows(), (Rows::kReach + 1) * rows_.height());

  const TreadColumns columns{.first = 1 - static_cast<int>(Rows::kHalfNodes), .spacing = Rows::kDistance};
  const SideProduct product({Rows::kCount, 2 * Rows::kHalfNodes - 1}, columns, difference, factors, false);
  const HalfField first = forces();
  const HalfField second = forces();
  const auto work = [&](const HalfField& on, const HalfField& by) {
    return (unfolded(on, rows_) * product.apply(unfolded(by, rows_))).sum();
  };
  // Rows behind the load have the mirrored influence, in which phi components change their sign.
  Eigen::VectorXd reversed = Eigen::VectorXd::Ones(rows_.height());
  if (rows_.components == 3) reversed.segment(Rows::kHalfNodes, Rows::kHalfNodes).setConstant(-1.0);
  double by_rows = 0.0;
  for (Index displaced = 0; displaced < Rows::kCount; ++displaced) {
    for (Index loaded = 0; loaded < Rows::kCount; ++loaded) {
      const auto block = influence.middleRows(std::abs(displaced - loaded) * rows_.height(), rows_.height());
      const Eigen::VectorXd sense = displaced < loaded ? reversed : Eigen::VectorXd::Ones(rows_.height());
      by_rows += first.col(displaced).cwiseProduct(sense).dot(block * second.col(loaded).cwiseProduct(sense));
    }
  }
  const double expected = 0.5 * (work(first, second) + work(second, first));
  EXPECT_NE(work(first, second), work(second, first));
  EXPECT_NEAR(by_rows, expected, 1e-12 * std::abs(work(first, first)));
}

INSTANTIATE_TEST_SUITE_P(Components, SideInfluenceOfRows, testing::Values(1, 3));

/// At every frequency, and in the relaxed and instantaneous limits, the weights agree with sections solved there.
TEST(SideWeights, AgreeWithSectionsAtAnyFrequency) {
  const CoatedWheel wheel = creeping_wheel();
  const Observer silent;
  Watch watch(silent);
  constexpr double kTolerance = 1e-3;
  const LayerSpectrum spectrum(layered_body(wheel), kRange, kTolerance);
  const auto weights = side_weights(spectrum, wheel, false, 1, watch);
  ASSERT_EQ(weights->size(), spectrum.weights());
  const SideDifference sections(wheel, false);
  const Index lines = weights->front().amplitudes();
  constexpr std::array kEven{kEvenPart};
  constexpr double kAtOnce = 1e9;
  const Worker worker{.number = 0, .checkpoint = [] {}};
  for (const Index order : {0, 9}) {
    const double m = weights->front().orders[order];
    for (const double omega : {0.0, 3.0, 50.0, kAtOnce}) {
      Eigen::MatrixXcd sum = weights->front().parts[kEvenPart].row(order).reshaped(lines, lines);
      for (std::size_t j = 1; j < weights->size(); ++j) {
        const cplx lag(1.0, omega * spectrum.retardation_times()[j - 1]);
        sum += (*weights)[j].parts[kEvenPart].row(order).reshaped(lines, lines) / lag;
      }
      std::vector<cplx> moduli;
      moduli.reserve(wheel.layers.size());
      for (const Layer& layer : wheel.layers) {
        moduli.push_back(complex_modulus(layer.shear_modulus, std::array{omega}).front());
      }
      const LayerStack<cplx> stack = layered_body(wheel).stack(moduli, 0.0);
      const cplx unit = moduli.back();
      const Eigen::MatrixXcd exact = sections.at(m, section_media(stack, unit), kEven, worker)[kEvenPart] / unit;
      // The relaxed and instantaneous limits do not depend on times, or on how sums represent single times; otherwise
      // the error is 3e-5.
      const double allowed = omega == 0.0 || omega == kAtOnce ? 1e-6 : 1e-4;
      EXPECT_LT((sum - exact).cwiseAbs().maxCoeff(), allowed * exact.cwiseAbs().maxCoeff()) << m << ' ' << omega;
    }
  }
}

}  // namespace
}  // namespace viscoroll::detail
