#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "cases.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/mesh_model.hpp"
#include "rolling/rolling_contact.hpp"
#include "viscoroll/modal.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ratio_of(double nu) { return (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)); }

/// Of layers that end at a radius of 1 m, where a way across is straight or nothing varies.
template <class Scalar>
Matrix3<Scalar> compliance_of(std::vector<Medium<Scalar>> media, Way across, double m, double n) {
  const LayerStack<Scalar> layers{.metric = {.radius = 1.0, .across = across}, .media = std::move(media)};
  return surface_compliance(layers, m, n);
}

/// One layer on a rigid base, per length 1 m.
Matrix3<double> plane_compliance(double thickness, double nu, double m, double n) {
  const LayerStack<double> layers{.metric = {.radius = 1.0, .along = Way::line, .across = Way::line},
                                  .media = {{-thickness, 0.0, 1.0, ratio_of(nu), 0.0}}};
  return surface_compliance(layers, m, n);
}

TEST(WheelOrders, AreThoseOfARollerWhereNothingVariesAcross) {
  const std::vector<Medium<cplx>> media{{0.7, 0.85, cplx(3.0, 1.0), ratio_of(0.5), 1e-3},
                                        {0.85, 1.0, cplx(1.0, 0.2), cplx(ratio_of(0.4), 0.01), 2e-3}};
  for (const double m : {0.0, 1.0, 2.0, 7.0, 60.0, 900.0}) {
    const Matrix3<cplx> wheel = compliance_of(media, Way::line, m, 0.0);
    const Matrix3<cplx> roller = compliance_of(media, Way::nothing, m, 0.0);
    EXPECT_LT((wheel - roller).norm(), 1e-12 * roller.norm()) << m;
  }
}

TEST(WheelOrders, TendToAPlaneLayersLinearlyInTheThickness) {
  for (const double nu : {0.3, 0.5}) {
    const auto deviation = [nu](double thickness) {
      const double m = 0.7 / thickness;
      const double n = 0.8 / thickness;
      const Matrix3<double> plane = plane_compliance(thickness, nu, m, n);
      const Medium<double> layer{1.0 - thickness, 1.0, 1.0, ratio_of(nu), 0.0};
      return Matrix3<double>((compliance_of<double>({layer}, Way::line, m, n) - plane) / plane(0, 0));
    };
    const Matrix3<double> thin = deviation(1e-4);
    EXPECT_LT(thin.norm(), 1e-3);
    EXPECT_LT((thin - 0.1 * deviation(1e-3)).norm(), 0.01 * thin.norm()) << nu;  // second order: h / R
  }
}

TEST(WheelOrders, TendToAHalfSpace) {
  const double nu = 0.3;
  const Medium<double> layer{0.5, 1.0, 2.0, ratio_of(nu), 0.0};
  for (const double angle : {0.0, 0.5, 1.5}) {
    const double k = 1e4;
    const double normal = compliance_of<double>({layer}, Way::line, k * std::cos(angle), k * std::sin(angle))(0, 0);
    EXPECT_NEAR(normal, (1.0 - nu) / (2.0 * k), 3.0 / k * normal);
  }
}

TEST(WheelOrders, OrderZeroOfAnIncompressibleTreadIsHeld) {
  const Medium<double> layer{0.8, 1.0, 1.0, 0.0, 0.0};
  EXPECT_EQ(compliance_of<double>({layer}, Way::line, 0.0, 0.0)(0, 0), 0.0);
  const double tenth = compliance_of<double>({layer}, Way::line, 0.0, 0.1)(0, 0);
  EXPECT_NEAR(compliance_of<double>({layer}, Way::line, 0.0, 0.01)(0, 0) / tenth, 0.01, 1e-3);  // like k^2
}

CoatedWheel crowned(double crown_radius, double width = 0.08) {
  return {.core_radius = 0.04,
          .layers = {{.thickness = 0.01, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}},
          .width = width,
          .crown_radius = crown_radius,
          .sides = Sides::endless};
}

TEST(WheelOrders, BothCurvaturesCountAlike) {
  CoatedWheel wheel = crowned(0.05);
  wheel.layers[0].shear_modulus = Elastic{2e6};
  const LayeredBody layers = layered_body(wheel);
  const HarmonicBody body(layers, 1.0, {3.0, 14.0});
  const Eigen::Matrix3cd one = body.compliance({.i = 0, .n = 14.0});
  Eigen::Matrix3cd other = body.compliance({.i = 1, .n = 3.0});
  const Eigen::PermutationMatrix<3> turned(Eigen::Vector3i(0, 2, 1));
  other = turned * other * turned;
  EXPECT_LT((one - other).norm(), 1e-12 * one.norm());
}

TEST(WheelOrders, ATightCrownCountsInProportion) {
  const auto change = [](double crown_radius) {
    CoatedWheel wheel = crowned(crown_radius, 0.01);
    wheel.hub = Hub::crowned;
    const auto normal = [](const CoatedWheel& any) {
      return HarmonicBody(layered_body(any), 1.0, {5.0}).compliance({.i = 0, .n = 20.0})(0, 0);
    };
    return normal(wheel) - normal(crowned(kInfinity, 0.01));
  };
  EXPECT_LT(std::abs(2.0 * change(0.02) - change(0.01)), 1e-9 * std::abs(change(0.01)));
  EXPECT_LT(std::abs(change(0.2) - 0.1 * change(0.02)), 1e-9 * std::abs(change(0.2)));  // 20 thicknesses
}

TEST(WheelOrders, WavesAreHeardAtTheSpeedOfARollersAtTheLatest) {
  CoatedWheel wheel = crowned(kInfinity);
  wheel.layers[0].density = 1000.0;
  const CoatedCylinder roller{.core_radius = wheel.core_radius, .layers = wheel.layers};
  EXPECT_LE(critical_speed(wheel), critical_speed(roller));
  EXPECT_GT(critical_speed(wheel), 0.9 * critical_speed(roller));
}

}  // namespace
}  // namespace viscoroll::detail
