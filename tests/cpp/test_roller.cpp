#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "modal/centrifugal.hpp"
#include "modal/compliance_recursion.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr double kInner = 0.04;
constexpr double kOuter = 0.05;

double ratio_of(double nu) { return (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)); }

/// Displacement per stress of one order: radial, circumferential (i v due to i tau), and axial.
template <class Scalar>
struct LineCompliance {
  Scalar normal, mixed, along, axial;
};

/// Compliance of layers on a rigid core.
template <class Scalar>
LayerStack<Scalar> stack_of(std::vector<Medium<Scalar>> media) {
  return {.metric = {.radius = media.back().outer, .across = AxisKind::nothing}, .media = std::move(media)};
}

template <class Scalar>
LineCompliance<Scalar> cylinder_compliance(std::vector<Medium<Scalar>> media, double m) {
  const Matrix3<Scalar> y = surface_compliance(stack_of(std::move(media)), m, 0.0);
  return {.normal = y(0, 0), .mixed = y(0, 1), .along = y(1, 1), .axial = y(2, 2)};
}

bool is_subcritical(const LayerStack<double>& layers, double m) {
  const OrderInLayers<double> order{.layers = layers, .m = m, .n = 0.0};
  return are_subcritical(std::span(&order, 1));
}

/// Michell's stress function of order m >= 2 on a ring that is bonded inside (S. Timoshenko and J. N. Goodier, Theory
/// of Elasticity, 3rd ed., section 43): (A r^m + B r^(m+2) + C r^-m + D r^(2-m)) cos(m phi), u due to -sigma_rr alone
/// etc. Displacements by integration of Hooke's law in plane strain, kappa = 3 - 4 nu.
LineCompliance<cplx> michell(cplx mu, double nu, double m) {
  using Matrix = Eigen::Matrix<cplx, 4, 4>;
  const double kappa = 3.0 - 4.0 * nu;
  // Columns are unit amplitudes; rows are 2 mu u / cos, 2 mu u_phi / sin, sigma_rr / cos and sigma_rphi / sin.
  const auto rows = [&](double r) {
    Matrix z;
    const std::array<double, 4> n{m, m + 2.0, -m, 2.0 - m};
    for (int j = 0; j < 4; ++j) {
      const double p = n[static_cast<std::size_t>(j)];
      const bool biharmonic = j % 2 == 1;
      // The stress function r^p cos(m phi) has sigma_rr = (p - m^2) r^(p-2) and sigma_rphi = m (p - 1) r^(p-2).
      z(2, j) = (p - m * m) * std::pow(r, p - 2.0);
      z(3, j) = m * (p - 1.0) * std::pow(r, p - 2.0);
      // 2 mu u_r = -d phi/dr + (kappa + 1)/4 r d psi/dphi with laplace(phi) = d(r d psi/dphi)/dr, see Barber,
      // Elasticity, table 9.1.
      const double up = std::pow(r, p - 1.0);
      if (!biharmonic) {
        z(0, j) = -p * up;
        z(1, j) = m * up;
      } else if (j == 1) {
        z(0, j) = (kappa - m - 1.0) * up;
        z(1, j) = (kappa + m + 1.0) * up;
      } else {
        z(0, j) = (kappa + m - 1.0) * up;
        z(1, j) = -(kappa - m + 1.0) * up;
      }
    }
    return z;
  };
  Matrix system;
  system.topRows<2>() = rows(kInner / kOuter).topRows<2>();
  system.bottomRows<2>() = rows(1.0).bottomRows<2>();
  const auto inverse = system.fullPivLu();
  const auto displacement = [&](double rr, double rphi) -> Eigen::Vector2cd {
    const Eigen::Vector4cd amplitudes = inverse.solve(Eigen::Vector4cd{0.0, 0.0, rr, rphi});
    return rows(1.0).topRows<2>() * amplitudes * (kOuter / (2.0 * mu));
  };
  // u cos(m phi) and u_phi sin(m phi) are the real parts of u e^(i m phi) and i v e^(i m phi) with v = -u_phi.
  const Eigen::Vector2cd by_normal = displacement(1.0, 0.0);
  const Eigen::Vector2cd by_shear = displacement(0.0, -1.0);
  const double e = std::pow(kInner / kOuter, m);
  return {.normal = by_normal[0],
          .mixed = by_shear[0],
          .along = -by_shear[1],
          .axial = kOuter / (mu * m) * (1.0 - e * e) / (1.0 + e * e)};
}

void expect_near(cplx value, cplx expected, double size) { EXPECT_LT(std::abs(value - expected), 1e-12 * size); }

TEST(CylinderCompliance, AgreesWithMichell) {
  const cplx mu(3e6, 1e6);
  for (const double nu : {0.3, 0.5, -0.4}) {
    for (const double m : {2.0, 5.0, 40.0}) {
      const auto found = cylinder_compliance<cplx>(
          {{.inner = kInner, .outer = kOuter, .mu = mu, .b = ratio_of(nu), .inertia = 0.0}}, m);
      const auto exact = michell(mu, nu, m);
      expect_near(found.normal, exact.normal, std::abs(exact.normal));
      expect_near(found.mixed, exact.mixed, std::abs(exact.along));
      expect_near(found.along, exact.along, std::abs(exact.along));
      expect_near(found.axial, exact.axial, std::abs(exact.axial));
    }
  }
}

TEST(CylinderCompliance, OfOrderZeroExpandsAndTwists) {
  // Compare with a tube under uniform pressure and a tube twisted about its core: docs/theory/rollers.md.
  const double mu = 2e6;
  const double nu = 0.3;
  const double lambda = 2.0 * mu * nu / (1.0 - 2.0 * nu);
  const double e2 = std::pow(kInner / kOuter, 2);
  const auto found = cylinder_compliance<double>(
      {{.inner = kInner, .outer = kOuter, .mu = mu, .b = ratio_of(nu), .inertia = 0.0}}, 0.0);
  EXPECT_NEAR(found.normal * (2.0 * (lambda + mu) + 2.0 * mu * e2) / (kOuter * (1.0 - e2)), 1.0, 1e-13);
  EXPECT_NEAR(found.along * 2.0 * mu / (kOuter * (1.0 / e2 - 1.0)), 1.0, 1e-13);
  EXPECT_EQ(found.mixed, 0.0);
}

TEST(CylinderCompliance, OfTwoLayersOfOneMaterialIsThatOfOne) {
  const cplx mu(3e6, 1e6);
  // V^2 is a fifth of the squared speed of shear waves.
  const double inertia = 0.2 * 3e6 / std::pow(kOuter, 2);
  const auto medium = [&](double inner, double outer) {
    return Medium<cplx>{.inner = inner, .outer = outer, .mu = mu, .b = 0.1, .inertia = inertia};
  };
  for (const double m : {0.0, 1.0, 3.5, 300.0}) {
    const auto one = cylinder_compliance<cplx>({medium(kInner, kOuter)}, m);
    const auto two = cylinder_compliance<cplx>({medium(kInner, 0.047), medium(0.047, kOuter)}, m);
    expect_near(two.normal, one.normal, std::abs(one.normal));
    expect_near(two.along, one.along, std::abs(one.along));
    expect_near(two.axial, one.axial, std::abs(one.axial));
  }
}

TEST(CylinderCompliance, OfHighOrdersIsThatOfAHalfPlane) {
  const double m = 1e5;
  const double nu = 0.4;
  const auto found = cylinder_compliance<double>(
      {{.inner = kInner, .outer = kOuter, .mu = 1.0, .b = ratio_of(nu), .inertia = 0.0}}, m);
  // The curvature causes differences of the order 1/m.
  EXPECT_NEAR(found.normal * m / kOuter, 1.0 - nu, 2.0 / m);
  EXPECT_NEAR(found.along * m / kOuter, 1.0 - nu, 2.0 / m);
  EXPECT_NEAR(found.mixed * m / kOuter, -0.5 * (1.0 - 2.0 * nu), 2.0 / m);
  EXPECT_NEAR(found.axial * m / kOuter, 1.0, 2.0 / m);
}

TEST(CylinderCompliance, HasNoStiffnessAtTheRayleighSpeed) {
  // With mu = rho = r_o = 1, incompressible waves of high order travel at 0.9553 of the speed of shear waves (Graff).
  const auto at_speed = [](double speed) {
    return stack_of<double>({{.inner = 0.5, .outer = 1.0, .mu = 1.0, .b = 0.0, .inertia = speed * speed}});
  };
  EXPECT_TRUE(is_subcritical(at_speed(0.954), 2000.0));
  EXPECT_FALSE(is_subcritical(at_speed(0.957), 2000.0));
}

TEST(CylinderCompliance, GrowsByCentrifugalForce) {
  // u'' + u'/r - u/r^2 = -rho Omega^2 r / (lambda + 2 mu), u(r_i) = 0 and sigma_rr(r_o) = 0, without the inertia of the
  // displacement itself, which is of the order rho (Omega r)^2 / mu = 1e-6.
  const double nu = 0.3;
  const double mu = 1.0;
  const double lambda = 2.0 * mu * nu / (1.0 - 2.0 * nu);
  const double inertia = 1e-6;
  const double ri = 0.6;
  const double confined = lambda + 2.0 * mu;
  const double f = inertia / (8.0 * confined);  // u = A r + B / r - f r^3
  Eigen::Matrix2d system{{ri, 1.0 / ri}, {2.0 * (lambda + mu), -2.0 * mu}};
  const Eigen::Vector2d right{f * std::pow(ri, 3), f * (3.0 * confined + lambda)};
  const Eigen::Vector2d amplitude = system.inverse() * right;
  const auto layers = stack_of<cplx>({{.inner = ri, .outer = 1.0, .mu = mu, .b = ratio_of(nu), .inertia = inertia}});
  EXPECT_NEAR(centrifugal_states(layers).back()(0) / (amplitude.sum() - f), 1.0, 1e-5);
}

/// Roller with a core of 50 mm and 10 mm of an incompressible standard linear solid, 6 and 3 MPa and 0.125 s.
CoatedCylinder rubber_roller() {
  return {.core_radius = 50e-3,
          .layers = {{.thickness = 10e-3, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}}};
}

TEST(Roller, AgreesWithAnIndependentProgram) {
  // Moments per length from an independent code in NumPy, accurate to 0.3 % (docs/theory/rollers.md).
  const std::array<std::array<double, 2>, 3> known{{{0.1, 2.806}, {1.0, 2.456}, {10.0, 0.2888}}};
  for (const auto& [speed, moment] : known) {
    const Result result = solve(rubber_roller(), {.load = 5e3, .angular_speed = speed}, {.accuracy = 1e-3});
    EXPECT_EQ(result.status, Status::converged);
    EXPECT_NEAR(result.resisting_torque / moment, 1.0, 0.003);
    EXPECT_LT(result.energy_balance_error, 1e-3);
    EXPECT_EQ(result.theta_nodes, 1);
  }
}

/// Hertz's line contact has a^2 = 2 (1 - nu) P R / (pi G), p_0 = 2 P / (pi a) (Johnson, Contact Mechanics,
/// section 4.2).
TEST(Roller, AgreesWithHertzOnAnElasticHalfPlane) {
  const CoatedCylinder rigid{.core_radius = 0.1, .layers = {}};
  const CoatedPlane floor{.layers = {}, .base = HalfSpace{.shear_modulus = Elastic{1e8}, .poisson_ratio = 0.3}};
  const double load = 1e4;
  const double a = std::sqrt(2.0 * 0.7 * load * 0.1 / (std::numbers::pi * 1e8));
  const Result result = solve(rigid, floor, {.load = load, .angular_speed = 1.0}, {.mesh = Mesh{150000}});
  double second_moment = 0.0;  // of the pressure about the center: a^2 / 4 times the load
  for (std::size_t i = 0; i < result.x.size(); ++i) second_moment += std::pow(result.x[i], 2) * result.pressure[i];
  second_moment *= 0.1 * phi_spacing(result.mesh) / load;
  EXPECT_NEAR(2.0 * std::sqrt(second_moment) / a, 1.0, 1e-4);
  EXPECT_NEAR(result.max_pressure / (2.0 * load / (std::numbers::pi * a)), 1.0, 1e-4);
  EXPECT_FALSE(result.penetration);
  EXPECT_FALSE(result.model_error);
  EXPECT_NEAR(result.resisting_torque, 0.0, 1e-9 * load * a);
}

TEST(Roller, NeedsNoTorqueIfItIsRigid) {
  const CoatedCylinder rigid{.core_radius = 0.05, .layers = {}};
  const CoatedPlane floor{.layers = {}, .base = HalfSpace{.shear_modulus = cases::rubber(), .poisson_ratio = 0.5}};
  const Result result = solve(rigid, floor, {.load = 5e3, .angular_speed = 1.0}, {.accuracy = 1e-3});
  EXPECT_NEAR(result.driving_force * 0.05 / result.resisting_torque, 1.0, 1e-3);  // Q = M / R
  EXPECT_NEAR(result.driving_torque, 0.0, 1e-3 * result.resisting_torque);
  EXPECT_LT(result.energy_balance_error, 1e-3);
  // Hunter's closed form, which the Python tests compare with an independent computation: 4.26712 N.
  EXPECT_NEAR(result.resisting_torque / 4.26712, 1.0, 1e-3);
}

TEST(Roller, OnAnIdenticalRollerActsAsOnARigidPlane) {
  const Result plane = solve(rubber_roller(), {.load = 5e3, .angular_speed = 1.0}, {.mesh = Mesh{6000}});
  const Result pair =
      solve(rubber_roller(), rubber_roller(), {.load = 5e3, .angular_speed = 1.0}, {.mesh = Mesh{6000}});
  // Twice the gap and twice the compliance give the same forces and twice the approach.
  EXPECT_NEAR(pair.resisting_torque / plane.resisting_torque, 1.0, 1e-9);
  // The torque of the pair follows from difference quotients on the mesh.
  EXPECT_NEAR(pair.driving_torque / plane.driving_torque, 1.0, 1e-3);
  EXPECT_NEAR(*pair.penetration / *plane.penetration, 2.0, 1e-9);
  EXPECT_NEAR(pair.bulk_power / plane.bulk_power, 2.0, 1e-9);
  EXPECT_LT(pair.energy_balance_error, 2e-3);
}

TEST(Roller, FollowsCartersCurve) {
  // A thick incompressible coating on a rigid plane does not slip under pressure alone. With a = R / 1000, the creepage
  // of free rolling, of the order (a/R)^2, is small compared with mu a / R, at which the whole contact slides.
  const double radius = 0.1;
  const double shear = 1e7;
  const double a = 1e-3 * radius;
  const double load = std::numbers::pi * shear * a * a / radius;
  const double friction = 0.3;
  const CoatedCylinder roller{
      .core_radius = 0.4 * radius,
      .layers = {{.thickness = 0.6 * radius, .shear_modulus = Elastic{shear}, .poisson_ratio = 0.5}}};
  const RollingModel model(roller, 1.0, Mesh{static_cast<int>(100.0 * std::numbers::pi * radius / a)});
  for (const double share : {-0.2, 0.1, 0.2, 0.5, 0.8}) {
    const double creepage = share * friction * a / radius;
    const Result result = model.solve(
        {.load = load, .angular_speed = 1.0, .friction = friction, .drive = DriveCreepage{.creepage = creepage}});
    const double carter = std::copysign(friction * load * (1.0 - std::pow(1.0 - std::abs(share), 2)), share);
    // The error of the mesh is inversely proportional to the number of nodes, here 100 across; the creepage of free
    // rolling is about (a/R)^2.
    EXPECT_NEAR(result.driving_force / (friction * load), carter / (friction * load), 0.01);
    EXPECT_NEAR(result.driving_force / carter, 1.0, 0.02);
  }
}

}  // namespace
}  // namespace viscoroll::detail
