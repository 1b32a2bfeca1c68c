#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <ostream>
#include <span>

#include "cases.hpp"
#include "modal/harmonic_body.hpp"
#include "modal/harmonic_moduli.hpp"
#include "modal/layer_system.hpp"
#include "modal/order_panels.hpp"
#include "modal/self_similar.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Compliance of one order from the spectrum and from the recursion, and their largest difference relative to the
/// largest entry of its row and column (C_ij^2 <= C_ii C_jj).
double spectrum_error(const Spectrum& spectrum, const HarmonicBody& coating, std::size_t i, double n) {
  OrderSeries series;
  spectrum.series(i, series);
  const double m = coating.orders()[i];
  const Eigen::ArrayXd orders = Eigen::ArrayXd::Constant(1, n);
  const OrderValues order(m, orders, series);
  Eigen::Matrix3cd sum;
  Eigen::ArrayXcd values;
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t q = 0; q < 3; ++q) {
      const SignedEntry entry = entry_of(p, q);
      order.evaluate(entry.entry, values);
      sum(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)) = entry.sign * values[0];
    }
  }
  const Eigen::Matrix3cd exact = to_physical(coating.compliance({.i = i, .n = n}));
  double error = 0.0;
  for (int p = 0; p < 3; ++p) {
    for (int q = 0; q < 3; ++q) {
      const double size = std::sqrt(std::abs(exact(p, p)) * std::abs(exact(q, q)));
      if (size > 0.0) error = std::max(error, std::abs(sum(p, q) - exact(p, q)) / size);
    }
  }
  return error;
}

double worst_spectrum_error(const Spectrum& spectrum, const HarmonicBody& coating) {
  double worst = 0.0;
  for (std::size_t i = 0; i < coating.orders().size(); ++i) {
    for (const double n : {0.0, 1.0, 2.0, 5.0, 19.25, 80.0, 399.0}) {
      worst = std::max(worst, spectrum_error(spectrum, coating, i, n));
    }
  }
  return worst;
}

/// Some orders m, integer and non-integer.
std::vector<double> some_orders() { return {0.0, 1.0, 2.0, 3.0, 7.5, 20.0, 61.7, 150.0, 400.0}; }
constexpr double kHighestN = 400.0;

struct SpectrumCase {
  const char* name;
  double core_radius;
  double thickness;
  double poisson_ratio;
  double density;
  double angular_speed;
};

void PrintTo(const SpectrumCase& c, std::ostream* out) { *out << c.name; }

class SpectrumTest : public testing::TestWithParam<SpectrumCase> {
 protected:
  [[nodiscard]] HarmonicBody coating() const {
    const SpectrumCase& c = GetParam();
    const CoatedSphere sphere{.core_radius = c.core_radius,
                              .layers = {{.thickness = c.thickness,
                                          .shear_modulus = cases::rubber(),
                                          .poisson_ratio = c.poisson_ratio,
                                          .density = c.density}}};
    return {layered_body(sphere), c.angular_speed, some_orders()};
  }

  Observer observer_;
  Watch watch_{observer_};
};

TEST_P(SpectrumTest, SharedResponseAgreesWithTheRecursion) {
  const HarmonicBody coating = this->coating();
  const auto spectrum = SelfSimilarSpectrum::try_make(coating, kHighestN, kInertiaTolerance, 2, watch_);
  ASSERT_TRUE(spectrum);
  // Series are truncated at 1e-13 and the inertia series at 1e-12; the tolerance is a sum of a few such errors.
  EXPECT_LT(worst_spectrum_error(*spectrum, coating), 1e-11);
}

TEST_P(SpectrumTest, OrderByOrderAgreesWithTheRecursion) {
  const HarmonicBody coating = this->coating();
  EXPECT_LT(
      worst_spectrum_error(OrderByOrderSpectrum(std::make_shared<const HarmonicBody>(coating), kHighestN), coating),
      1e-11);
}

INSTANTIATE_TEST_SUITE_P(Coatings, SpectrumTest,
                         testing::Values(SpectrumCase{"Paper", 20e-3, 1e-3, 0.5, 0.0, 2.5},
                                         SpectrumCase{"PaperWithInertia", 20e-3, 1e-3, 0.5, 1000.0, 2.5},
                                         SpectrumCase{"Faster", 20e-3, 1e-3, 0.5, 1000.0, 20.0},
                                         SpectrumCase{"Thin", 20e-3, 20e-6, 0.5, 1000.0, 2.5},
                                         SpectrumCase{"ThinCompressible", 20e-3, 20e-6, 0.3, 1000.0, 2.5},
                                         SpectrumCase{"Thick", 20e-3, 20e-3, 0.5, 0.0, 2.5},
                                         SpectrumCase{"NearlySolid", 20e-6, 20e-3, 0.45, 1000.0, 2.5},
                                         SpectrumCase{"Auxetic", 20e-3, 5e-3, -0.5, 1000.0, 2.5}),
                         [](const auto& info) { return info.param.name; });

TEST(Spectrum, OrderByOrderSupportsDissimilarLayersAndHighSpeeds) {
  for (const double speed : {2.5, 300.0}) {
    const HarmonicBody coating(layered_body(cases::dissimilar_layers(1000.0)), speed, some_orders());
    EXPECT_LT(
        worst_spectrum_error(OrderByOrderSpectrum(std::make_shared<const HarmonicBody>(coating), kHighestN), coating),
        1e-11)
        << speed;
  }
}

TEST(Spectrum, SelfSimilarityIsRecognized) {
  const Observer observer;
  Watch watch(observer);
  const auto is_shared = [&](const CoatedSphere& sphere, double speed) {
    const HarmonicBody coating(layered_body(sphere), speed, some_orders());
    return SelfSimilarSpectrum::try_make(coating, kHighestN, kInertiaTolerance, 1, watch) != nullptr;
  };
  CoatedSphere two = cases::paper_sphere();
  two.layers.push_back({.thickness = 2e-3,
                        .shear_modulus = standard_linear_solid(1.2e6, 0.6e6, 0.125),
                        .poisson_ratio = 0.3,
                        .density = 500.0});
  EXPECT_TRUE(is_shared(two, 2.5));
  EXPECT_FALSE(is_shared(cases::dissimilar_layers(), 2.5));
  EXPECT_FALSE(is_shared(cases::paper_sphere(), 1000.0)) << "inertia beyond its series";
}

TEST(Spectrum, SelfSimilarSpectrumNeglectsInertiaWithinItsTolerance) {
  const Observer observer;
  Watch watch(observer);
  const HarmonicBody coating(layered_body(cases::paper_sphere()), 100.0, some_orders());
  EXPECT_EQ(SelfSimilarSpectrum::try_make(coating, kHighestN, kInertiaTolerance, 1, watch), nullptr);
  constexpr double kTolerance = 1e-5;
  const auto spectrum = SelfSimilarSpectrum::try_make(coating, kHighestN, kTolerance, 1, watch);
  ASSERT_TRUE(spectrum);
  EXPECT_LT(worst_spectrum_error(*spectrum, coating), kTolerance);
}

TEST(HighestKink, IsFoundAtAnyFrequency) {
  const auto bent_at = [](double kink) {
    return CustomModulus{[kink](std::span<const double> omega, std::span<std::complex<double>> modulus) {
      std::ranges::transform(omega, modulus.begin(), [kink](double w) {
        return std::complex<double>(1e6 * std::pow(1.0 + w, 0.4) * (1.0 + 1e-4 * std::max(w / kink - 1.0, 0.0)),
                                    w > 0.0);
      });
    }};
  };
  EXPECT_EQ(highest_kink(bent_at(1e9), 0.5, 2000.0), 0.0);
  for (const double kink : {0.8, 31.25, 62.5, 700.0}) {
    const double end = highest_kink(bent_at(kink), 0.5, 2000.0);
    EXPECT_GT(end, kink);
    EXPECT_LE(end, 2.0 * kink);
  }
}

/// A later stage evaluates the function at the frequencies of its orders, and reports those without a value.
TEST(HighestKink, CountsMissingValuesAsRough) {
  const CustomModulus nowhere{[](std::span<const double>, std::span<std::complex<double>> modulus) {
    std::ranges::fill(modulus, std::numeric_limits<double>::quiet_NaN());
  }};
  EXPECT_EQ(highest_kink(nowhere, 0.5, 2000.0), 2000.0);
}

TEST(CriticalSpeed, OfOneLayerIsThatOfRayleighWaves) {
  // 0.9553 sqrt(mu0 / rho), the root of the Rayleigh equation at Poisson's ratio 1/2 (docs/theory/inertia.md).
  EXPECT_NEAR(critical_speed(cases::paper_sphere()), 0.95531 * std::sqrt(6e6 / 1000.0) / 21e-3, 0.01);
  EXPECT_TRUE(std::isinf(critical_speed(cases::paper_sphere(0.0))));
}

TEST(CriticalSpeed, ASoftLayerBelowAStiffOneLowersIt) {
  CoatedSphere sphere = cases::paper_sphere();
  sphere.layers[0].thickness = 5e-3;
  const double alone = critical_speed(sphere);
  sphere.layers.push_back(sphere.layers[0]);
  sphere.layers[1].shear_modulus = Elastic{60e6};
  const double covered = critical_speed(sphere);
  EXPECT_LT(covered, std::sqrt(60e6 / 1000.0) / 30e-3);
  EXPECT_GT(covered, 0.5 * alone * 25.0 / 30.0);
}

}  // namespace
}  // namespace viscoroll::detail
