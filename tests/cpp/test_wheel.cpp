#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "influence/table_sums.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"
#include "modal/spectrum.hpp"
#include "rolling/mesh_model.hpp"
#include "rolling/rigid_slip.hpp"
#include "rolling/solve_load_case.hpp"
#include "rolling/warnings.hpp"
#include "viscoroll/modal.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ratio_of(double nu) { return (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)); }

/// Compliance of layers with an outer radius of 1 m, whose fields vary along a straight axis or not at all.
template <class Scalar>
Matrix3<Scalar> compliance_of(std::vector<Medium<Scalar>> media, AxisKind across, double m, double n) {
  const LayerStack<Scalar> layers{.metric = {.radius = 1.0, .across = across}, .media = std::move(media)};
  return surface_compliance(layers, m, n);
}

/// Compliance of one layer on a rigid base, for wave numbers m and n in 1/m.
Matrix3<double> plane_compliance(double thickness, double nu, double m, double n) {
  const LayerStack<double> layers{.metric = {.radius = 1.0, .along = AxisKind::line, .across = AxisKind::line},
                                  .media = {{-thickness, 0.0, 1.0, ratio_of(nu), 0.0}}};
  return surface_compliance(layers, m, n);
}

TEST(WheelOrders, AgreeWithARollerWithoutAxialVariation) {
  const std::vector<Medium<cplx>> media{{0.7, 0.85, cplx(3.0, 1.0), ratio_of(0.5), 1e-3},
                                        {0.85, 1.0, cplx(1.0, 0.2), cplx(ratio_of(0.4), 0.01), 2e-3}};
  for (const double m : {0.0, 1.0, 2.0, 7.0, 60.0, 900.0}) {
    const Matrix3<cplx> wheel = compliance_of(media, AxisKind::line, m, 0.0);
    const Matrix3<cplx> roller = compliance_of(media, AxisKind::nothing, m, 0.0);
    EXPECT_LT((wheel - roller).norm(), 1e-12 * roller.norm()) << m;
  }
}

TEST(WheelOrders, TendToAPlaneLayerInProportionToTheThickness) {
  for (const double nu : {0.3, 0.5}) {
    const auto deviation = [nu](double thickness) {
      const double m = 0.7 / thickness;
      const double n = 0.8 / thickness;
      const Matrix3<double> plane = plane_compliance(thickness, nu, m, n);
      const Medium<double> layer{1.0 - thickness, 1.0, 1.0, ratio_of(nu), 0.0};
      return Matrix3<double>((compliance_of<double>({layer}, AxisKind::line, m, n) - plane) / plane(0, 0));
    };
    const Matrix3<double> thin = deviation(1e-4);
    EXPECT_LT(thin.norm(), 1e-3);
    // The remainder is of second order in h / R.
    EXPECT_LT((thin - 0.1 * deviation(1e-3)).norm(), 0.01 * thin.norm()) << nu;
  }
}

TEST(WheelOrders, TendToAHalfSpace) {
  const double nu = 0.3;
  const Medium<double> layer{0.5, 1.0, 2.0, ratio_of(nu), 0.0};
  for (const double angle : {0.0, 0.5, 1.5}) {
    const double k = 1e4;
    const double normal =
        compliance_of<double>({layer}, AxisKind::line, k * std::cos(angle), k * std::sin(angle))(0, 0);
    EXPECT_NEAR(normal, (1.0 - nu) / (2.0 * k), 3.0 / k * normal);
  }
}

TEST(WheelOrders, OrderZeroOfAnIncompressibleTreadHasNoRadialCompliance) {
  const Medium<double> layer{0.8, 1.0, 1.0, 0.0, 0.0};
  EXPECT_EQ(compliance_of<double>({layer}, AxisKind::line, 0.0, 0.0)(0, 0), 0.0);
  const double tenth = compliance_of<double>({layer}, AxisKind::line, 0.0, 0.1)(0, 0);
  EXPECT_NEAR(compliance_of<double>({layer}, AxisKind::line, 0.0, 0.01)(0, 0) / tenth, 0.01,
              1e-3);  // proportional to k^2
}

CoatedWheel crowned(double crown_radius, double width = 0.08) {
  return {.core_radius = 0.04,
          .layers = {{.thickness = 0.01, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5}},
          .width = width,
          .crown_radius = crown_radius,
          .sides = Sides::unbounded};
}

TEST(WheelOrders, HaveSymmetricEffectsOfBothCurvatures) {
  CoatedWheel wheel = crowned(0.05, 0.02);
  wheel.layers[0].shear_modulus = Elastic{2e6};
  const LayeredBody layers = layered_body(wheel);
  const HarmonicBody body(layers, 1.0, {3.0, 14.0});
  const Eigen::Matrix3cd one = body.compliance({.i = 0, .n = 14.0});
  Eigen::Matrix3cd other = body.compliance({.i = 1, .n = 3.0});
  const Eigen::PermutationMatrix<3> turned(Eigen::Vector3i(0, 2, 1));
  other = turned * other * turned;
  EXPECT_LT((one - other).norm(), 1e-12 * one.norm());
}

TEST(WheelOrders, ChangeInProportionToTheCurvatureOfATightCrown) {
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

/// Scaling the first order of a tight crown amplifies round-off, which panels of any width cannot resolve.
TEST(WheelOrders, RoundOffOfATightCrownIsNotResolvedByPanels) {
  std::vector<double> orders(60);  // as close as the orders of one panel
  for (std::size_t i = 0; i < orders.size(); ++i) orders[i] = 2.0 * std::pow(8.0, static_cast<double>(i) / 59.0);
  const auto panels = [&](double crown_radius) {
    CoatedWheel wheel = crowned(crown_radius, 0.01);
    wheel.hub = Hub::crowned;
    const Observer silent;
    Watch watch(silent);
    const auto spectrum = make_spectrum(HarmonicBody(layered_body(wheel), 1.0, orders), 1e4, 1, watch);
    OrderSeries series;
    spectrum->series(orders.size() / 2, series);
    return series.size();
  };
  EXPECT_LE(panels(0.005), 2 * panels(0.3));
}

TEST(WheelOrders, CriticalSpeedIsAtMostThatOfARoller) {
  CoatedWheel wheel = crowned(kInfinity);
  wheel.layers[0].density = 1000.0;
  const CoatedCylinder roller{.core_radius = wheel.core_radius, .layers = wheel.layers};
  EXPECT_LE(critical_speed(wheel), critical_speed(roller));
  EXPECT_GT(critical_speed(wheel), 0.9 * critical_speed(roller));
}

/// Tables of patches whose width is not an integer fraction of a revolution.
class TreadTables : public ::testing::Test {
 protected:
  static constexpr int kReach = 40;

  [[nodiscard]] std::vector<Table> tables_of(const LayeredBody& layers, double theta, int aside) {
    const Mesh mesh{.nodes_per_revolution = kNodes, .theta_nodes_per_revolution = 500};
    return CoatingSum(layers, kSpeed, {mesh, 1.0, theta, aside * theta}, 1, watch_)
        .tables(requests_, kReach, aside, 1, watch_);
  }

  static constexpr int kNodes = 720;
  static constexpr double kSpeed = 2.5;
  Observer observer_;
  Watch watch_{observer_};
  std::vector<TableRequest> requests_{
      {.entry = Entry::rr}, {.entry = Entry::rphi}, {.entry = Entry::thetatheta}, {.entry = Entry::rr, .power = true}};
};

TEST_F(TreadTables, SumsAcrossAgreeWithTablesOfALineContact) {
  CoatedWheel wheel = crowned(kInfinity);
  wheel.layers.insert(wheel.layers.begin(), {.thickness = 0.004, .shear_modulus = Elastic{2e6}, .poisson_ratio = 0.4});
  const double radius = outer_radius(wheel);
  const double theta = 0.0127;
  // At a distance of twenty thicknesses, the influence vanishes.
  const int aside = 400;
  const std::vector<Table> tables = tables_of(layered_body(wheel), theta, aside);
  const LayeredBody roller = layered_body(CoatedCylinder{.core_radius = wheel.core_radius, .layers = wheel.layers});
  const Mesh mesh{.nodes_per_revolution = kNodes};
  std::vector<OrderBand> bands = phi_bands(roller, kSpeed, mesh);
  const HarmonicBody harmonics(roller, kSpeed, all_orders(bands));
  const LineSum line(std::move(bands), harmonics, mesh, 1, watch_);
  const std::vector<Table> lines = line.tables(requests_, kReach, 0, 1, watch_);
  for (std::size_t k = 0; k < requests_.size(); ++k) {
    double largest = 0.0;
    double error = 0.0;
    for (int j = -kReach; j <= kReach; ++j) {
      double sum = 0.0;
      for (int l = -aside; l <= aside; ++l) sum += tables[k](j, l);
      largest = std::max(largest, std::abs(lines[k](j, 0)));
      error = std::max(error, std::abs(sum * radius * theta - lines[k](j, 0)));
    }
    // Each of 801 offsets has an error of 1e-9 of the central value.
    EXPECT_LT(error, 4e-7 * largest) << k;
  }
}

/// A wheel whose layer equations are those of a wheel without crown.
class WheelWithFlatEquations final : public RoundBody {
 public:
  WheelWithFlatEquations(std::shared_ptr<const RoundBody> wheel, const CoatedWheel& flat)
      : RoundBody({.layers = wheel->layers(),
                   .curvatures = wheel->curvatures(),
                   .radius = wheel->radius(),
                   .width = wheel->width()}),
        wheel_(std::move(wheel)),
        flat_(make_body(flat)) {}

  [[nodiscard]] std::string_view name() const override { return wheel_->name(); }
  [[nodiscard]] BodySurface surface(const ContactKinematics& kinematics) const override {
    return flat_->surface(kinematics);
  }
  [[nodiscard]] LayeredBody layered(const SurfaceMotion& motion) const override { return flat_->layered(motion); }
  [[nodiscard]] Profile profile(const SurfaceWindow& points) const override { return wheel_->profile(points); }
  [[nodiscard]] Nodes nodes(const Mesh& mesh, const Body& on) const override { return wheel_->nodes(mesh, on); }
  [[nodiscard]] double further_error(const ContactReach& contact) const override {
    return wheel_->further_error(contact);
  }
  [[nodiscard]] std::vector<Warning> warnings(const ContactReach& contact, bool other_deforms) const override {
    return wheel_->warnings(contact, other_deforms);
  }

 private:
  std::shared_ptr<const RoundBody> wheel_;
  std::shared_ptr<const RoundBody> flat_;
};

/// Result for a wheel on the rigid plane.
Result roll(const CoatedWheel& wheel, double load, double angular_speed, const Mesh& mesh,
            bool knows_its_crown = true) {
  RollingPair pair = rolling_pair(wheel, CoatedPlane{});
  CoatedWheel flat = wheel;
  flat.crown_radius = kInfinity;
  if (!knows_its_crown) pair.body = std::make_shared<const WheelWithFlatEquations>(pair.body, flat);
  const Options options;
  Watch watch(options.observer);
  const PairAtSpeed at = at_speed(pair, angular_speed);
  const MeshModel model = make_model(at, mesh, options.curvature, {.threads = 1, .watch = watch});
  const LoadCase load_case{.load = load, .angular_speed = angular_speed};
  const RollingCase given = rolling_case(at, load_case, options, watch);
  Result result = solve_load_case(model, given);
  result.warnings = warnings_of(result, given, true);
  return result;
}

/// Torque from the dissipated power, which depends more smoothly on the nodes than that from the pressure [N m].
double torque_of(const Result& result, double angular_speed) { return result.bulk_power / angular_speed; }

struct Rolling {
  double speed;     ///< [rad/s]
  double torque;    ///< [N m]
  double approach;  ///< [m]
};

// The independent program in plain NumPy sums over both wave numbers and includes the crown only in the gap. The
// tolerance covers its five digits and the error of the mesh, 2e-4.
TEST(WheelRolling, AgreesWithAnotherProgram) {
  for (const Rolling& known : {Rolling{2.5, 0.24749, 0.58429e-3}, Rolling{25.0, 0.028318, 0.55510e-3}}) {
    const Result r = roll(crowned(0.3), 500.0, known.speed, {.nodes_per_revolution = 1600}, false);
    EXPECT_NEAR(torque_of(r, known.speed), known.torque, 2e-4 * known.torque);
    EXPECT_NEAR(*r.penetration, known.approach, 3e-5 * known.approach);
  }
}

TEST(WheelRolling, DissimilarLayersAgreeWithAnotherProgram) {
  CoatedWheel wheel = crowned(0.3);
  wheel.layers = {{.thickness = 0.006, .shear_modulus = cases::rubber(), .poisson_ratio = 0.5},
                  {.thickness = 0.004, .shear_modulus = standard_linear_solid(4e6, 1e6, 0.02), .poisson_ratio = 0.45}};
  const Result r = roll(wheel, 300.0, 2.5, {.nodes_per_revolution = 1600}, false);
  EXPECT_NEAR(torque_of(r, 2.5), 0.45161, 2e-4 * 0.45161);
  EXPECT_NEAR(*r.penetration, 0.65879e-3, 3e-5 * 0.65879e-3);
  EXPECT_NEAR(r.max_pressure, 1.1856e6, 5e-4 * 1.1856e6);
}

TEST(WheelRolling, FlatTreadsConvergeInProportionToTheSpacing) {
  for (const Rolling& known : {Rolling{2.5, 0.24121, 0.4595e-3}, Rolling{25.0, 0.026760, 0.4278e-3}}) {
    const auto at = [&](int nodes) {
      return roll(crowned(kInfinity, 0.03), 500.0, known.speed, {.nodes_per_revolution = nodes}, false);
    };
    const Result coarse = at(800);
    const Result fine = at(1600);
    const double torque = 2.0 * torque_of(fine, known.speed) - torque_of(coarse, known.speed);
    EXPECT_NEAR(torque, known.torque, 5e-4 * known.torque);
    EXPECT_NEAR(2.0 * *fine.penetration - *coarse.penetration, known.approach, 5e-4 * known.approach);
    EXPECT_EQ(std::ranges::count(fine.warnings, WarningKind::edge_pressure, &Warning::kind), 1);
  }
}

TEST(WheelRolling, WithEqualRadiiAgreesWithABall) {
  const Mesh mesh{.nodes_per_revolution = 1600};
  CoatedWheel wheel = crowned(0.05, 0.06);
  wheel.core_radius = 0.048;
  wheel.layers[0].thickness = 0.002;
  wheel.hub = Hub::crowned;
  Options options;
  options.mesh = mesh;
  options.curvature = Curvature::exact;
  const Result ball = solve(CoatedSphere{.core_radius = wheel.core_radius, .layers = wheel.layers},
                            LoadCase{.load = 100.0, .angular_speed = 2.5}, options);
  const Result r = roll(wheel, 100.0, 2.5, mesh);
  EXPECT_NEAR(torque_of(r, 2.5), torque_of(ball, 2.5), 3e-4 * torque_of(ball, 2.5));
  EXPECT_NEAR(*r.penetration, *ball.penetration, 3e-4 * *ball.penetration);
  // A wheel without the first order in the curvature has a larger error.
  const Result plain = roll(wheel, 100.0, 2.5, mesh, false);
  EXPECT_GT(std::abs(torque_of(plain, 2.5) / torque_of(ball, 2.5) - 1.0), 5e-3);
}

TEST(WheelRolling, AddedTorquePerWidthIsThatOfARoller) {
  const Mesh mesh{.nodes_per_revolution = 1600, .theta_nodes_per_revolution = 400};
  const double per_length = 500.0 / 0.03;
  const auto at = [&](double width) {
    return torque_of(roll(crowned(kInfinity, width), per_length * width, 2.5, mesh), 2.5);
  };
  const double added = (at(0.24) - at(0.12)) / 0.12;
  const CoatedWheel wheel = crowned(kInfinity);
  Options options;
  options.mesh = Mesh{.nodes_per_revolution = 1600};
  const Result roller = solve(CoatedCylinder{.core_radius = wheel.core_radius, .layers = wheel.layers},
                              LoadCase{.load = per_length, .angular_speed = 2.5}, options);
  EXPECT_NEAR(added, torque_of(roller, 2.5), 1e-3 * added);
}

TEST(WheelRolling, HeathcoteSlipFollowsTheSmallerCircles) {
  const CoatedWheel wheel = crowned(0.3);
  const RollingPair pair = rolling_pair(wheel, CoatedPlane{});
  const Nodes nodes = pair.body->nodes({.nodes_per_revolution = 2000}, *pair.on);
  const SurfaceWindow window(nodes.grid, {{-1, 1}, {-60, 60}});
  const RigidDisplacements rigid = rigid_slip(window, {}, SlipKinematics::exact, pair, {});
  const double step = window.grid().radius * window.grid().phi_spacing;
  const Window& range = window.window();
  for (const int k : {-60, -7, 0, 31}) {
    const Eigen::Index node = range.number_of(1, k);
    const double z = window.z()[node];
    const double drop = z * z / 0.6;  // z^2 / 2 R_c of a parabola, which causes Heathcote slip
    const double more = rigid.slip(node, 0) - rigid.slip(range.number_of(1, 0), 0);
    EXPECT_NEAR(more, step / window.grid().radius * drop, 4e-3 * step / window.grid().radius * drop + 1e-18) << k;
  }
  EXPECT_NEAR(-window.z()[range.number_of(0, 60)], 60.0 * nodes.grid.radius * nodes.grid.theta_spacing, 1e-12);
  EXPECT_NEAR((2 * nodes.widest.theta.last + 1) * nodes.grid.radius * nodes.grid.theta_spacing, wheel.width, 1e-12);
}

// The contact has 70 to 85 rows of nodes. The dissipated power follows from tables, and the power input from forces and
// moment arms.
TEST(WheelRolling, PowerBalancesWithFriction) {
  Options options;
  options.mesh = Mesh{.nodes_per_revolution = 1600, .theta_nodes_per_revolution = 800};
  LoadCase load_case{.load = 500.0, .angular_speed = 2.5, .friction = 0.5};
  const CoatedWheel crown = crowned(0.3);
  const auto error = [&](const CoatedWheel& wheel, const Counterbody& on, const Drive& drive) {
    load_case.drive = drive;
    return solve(wheel, on, load_case, options).energy_balance_error;
  };
  const CoatedPlane soft{.layers = crown.layers};
  EXPECT_LT(error(crown, CoatedPlane{}, DriveForce{0.0}), 3e-3);
  EXPECT_LT(error(crown, CoatedPlane{}, DriveCreepage{.creepage = 0.01, .lateral_creepage = 0.005, .spin = 0.5}), 3e-3);
  EXPECT_LT(error(crowned(kInfinity, 0.03), CoatedPlane{}, DriveForce{0.0}), 3e-3);
  EXPECT_LT(error(crown, soft, DriveTorque{1.0}), 3e-3);
}

/// J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), table E3: nu = 1/2, by the ratio of the
/// semi-axis along to that across. On a rigid plane, the combined modulus is twice that of the tread.
struct Kalker {
  double ratio;  ///< R_c / R; with 6.24, Hertz's semi-axes have the ratio 0.3
  double along, across, spin;
};

class KalkersCoefficients : public ::testing::TestWithParam<Kalker> {};

TEST_P(KalkersCoefficients, AgreeWithASmallContactOnAThickTread) {
  const Kalker& known = GetParam();
  constexpr double kModulus = 1e6;
  constexpr double kRadius = 0.05;
  CoatedWheel wheel = crowned(kRadius * known.ratio, std::min(0.02, 0.5 * kRadius * known.ratio));
  wheel.core_radius = 0.002;
  wheel.layers[0] = {
      .thickness = kRadius - wheel.core_radius, .shear_modulus = Elastic{kModulus}, .poisson_ratio = 0.5};
  wheel.hub = Hub::crowned;
  LoadCase load_case{.load = 1e-3 * std::min(1.0, known.ratio), .angular_speed = 1.0};
  Options options;
  options.accuracy = 0.05;
  const Result pressed = solve(wheel, load_case, options);
  const double along = pressed.semi_axis_x;
  const double across = *pressed.semi_axis_z;
  const auto nodes = [&](double axis) { return static_cast<int>(2.0 * std::numbers::pi * kRadius / (axis / 20.0)); };
  options.mesh = Mesh{.nodes_per_revolution = nodes(along), .theta_nodes_per_revolution = nodes(across)};
  options.slip_kinematics = SlipKinematics::flat;  // Kalker's bodies have no Heathcote slip
  load_case.friction = 1.0;
  const double creepage = 1e-3 * along / kRadius;
  const auto rolled = [&](const DriveCreepage& drive) {
    load_case.drive = drive;
    return solve(wheel, load_case, options);
  };
  const Result ahead = rolled({.creepage = creepage, .lateral_creepage = 0.0, .spin = 0.0});
  const Result behind = rolled({.creepage = -creepage, .lateral_creepage = 0.0, .spin = 0.0});
  const Result aside = rolled({.creepage = 0.0, .lateral_creepage = creepage, .spin = 0.0});
  const double unit = 2.0 * kModulus * creepage * ahead.contact_area / std::numbers::pi;
  EXPECT_NEAR((ahead.driving_force - behind.driving_force) / (2.0 * unit), known.along, 0.04 * known.along);
  EXPECT_NEAR(-aside.lateral_force / unit, known.across, 0.04 * known.across);
  const double size = std::sqrt(ahead.contact_area / std::numbers::pi);
  EXPECT_NEAR(-aside.spin_moment / (unit * size), known.spin, 0.04 * known.spin);
}

INSTANTIATE_TEST_SUITE_P(AlongPerAcross, KalkersCoefficients,
                         ::testing::Values(Kalker{6.24, 4.80, 2.81, 0.889}, Kalker{1.0, 5.20, 3.98, 1.63}));

TEST(WheelRolling, TwoIdenticalWheelsAreMirrorImages) {
  Options options;
  options.mesh = Mesh{.nodes_per_revolution = 600};
  const LoadCase load_case{.load = 500.0, .angular_speed = 2.5};
  const CoatedWheel wheel = crowned(0.3);
  const Result both = solve(wheel, wheel, load_case, options);
  const Result one = solve(wheel, CoatedPlane{}, load_case, options);
  EXPECT_NEAR(both.resisting_torque, one.resisting_torque, 1e-9 * one.resisting_torque);
  EXPECT_NEAR(*both.penetration, 2.0 * *one.penetration, 1e-9 * *both.penetration);
  EXPECT_NEAR(both.counterbody_bulk_power, both.rolling_bulk_power, 1e-9 * both.rolling_bulk_power);
}

}  // namespace
}  // namespace viscoroll::detail
