#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

#include "influence/table_sums.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"
#include "modal/order_panels.hpp"
#include "modal/spectrum.hpp"
#include "surface/sum_operator.hpp"
#include "surface/surface_operator.hpp"
#include "surface/table_operator.hpp"
#include "viscoroll/modal.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr cplx kRubber(3e6, 1e6);
constexpr cplx kStiff(2e7, 3e5);

cplx ratio(double nu) { return (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)); }

/// Layer with inertia rho V^2 [Pa].
struct FlatLayer {
  double thickness;
  cplx mu;
  cplx b;
  double inertia;
};

FlatLayer flat(double thickness, cplx mu, double nu, double inertia = 0.0) {
  return {.thickness = thickness, .mu = mu, .b = ratio(nu), .inertia = inertia};
}

/// Displacement per stress along the normal (u), along k (k) and across both (p).
struct FlatCompliance {
  cplx uu, uk, kk, pp;
};

FlatCompliance flat_compliance(std::span<const FlatLayer> layers, double k, double cosine) {
  constexpr double kRadius = 0.3;  // arbitrary
  LayerStack<cplx> stack{.metric = {.radius = kRadius, .along = AxisKind::line, .across = AxisKind::line}, .media = {}};
  double top = 0.0;
  for (const FlatLayer& layer : layers | std::views::reverse) {
    const double bottom = top - layer.thickness;
    stack.media.insert(stack.media.begin(), {.inner = bottom,
                                             .outer = std::exchange(top, bottom),
                                             .mu = layer.mu,
                                             .b = layer.b,
                                             .inertia = layer.inertia / std::pow(kRadius, 2)});
  }
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const Eigen::Matrix3cd y = surface_compliance(stack, k * kRadius * cosine, k * kRadius * sine);
  const Eigen::Vector3cd along(0.0, cosine, sine);
  const Eigen::Vector3cd across(0.0, -sine, cosine);
  return {.uu = y(0, 0),
          .uk = y.row(0) * along,
          .kk = (along.transpose() * y * along).value(),
          .pp = (across.transpose() * y * across).value()};
}

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double difference(const FlatCompliance& a, const FlatCompliance& b) {
  const double normal = std::abs(a.uu);
  const double along = std::abs(a.kk);
  return std::max({std::abs(a.uu - b.uu) / normal, std::abs(a.uk - b.uk) / std::sqrt(normal * along),
                   std::abs(a.kk - b.kk) / along, std::abs(a.pp - b.pp) / std::abs(a.pp)});
}

/// K. L. Johnson, Contact Mechanics (1985), section 5.8, and the same for forces along the surface: a layer bonded to a
/// rigid base, with x = exp(-2 k h). Independent of the recursion.
FlatCompliance bonded_layer(double h, cplx mu, double nu, double k) {
  const double s = k * h;
  const double x = std::exp(-2.0 * s);
  const double kappa = 3.0 - 4.0 * nu;
  const double n = kappa * (1.0 + x * x) + (1.0 + kappa * kappa + 4.0 * s * s) * x;
  const cplx unit = 1.0 / (mu * k * n);
  return {.uu = unit * (1.0 - nu) * (kappa * (1.0 - x * x) - 4.0 * s * x),
          .uk = unit * (2.0 * s * s * x - (1.0 - 2.0 * nu) * kappa * (1.0 - x) * (1.0 - x) / 2.0),
          .kk = unit * (1.0 - nu) * (kappa * (1.0 - x * x) + 4.0 * s * x),
          .pp = std::tanh(s) / (mu * k)};
}

/// D. M. Burmister, Journal of Applied Physics 16 (1945) 89: the normal compliance of a layer on a half-space.
cplx layer_on_half_space(double h, cplx mu_1, double nu_1, cplx mu_2, double nu_2, double k) {
  const double s = k * h;
  const double x = std::exp(-2.0 * s);
  const double kappa_1 = 3.0 - 4.0 * nu_1;
  const double kappa_2 = 3.0 - 4.0 * nu_2;
  const cplx r = mu_2 / mu_1;
  const cplx big_k = (1.0 - r) / (1.0 + r * kappa_1);
  const cplx big_l = (kappa_2 - r * kappa_1) / (kappa_2 + r);
  return (1.0 - nu_1) * (1.0 + 4.0 * big_k * s * x - big_l * big_k * x * x) /
         (mu_1 * k * (1.0 - (big_l + big_k + 4.0 * big_k * s * s) * x + big_l * big_k * x * x));
}

TEST(FlatLayers, LayerOnARigidBase) {
  for (const double nu : {-0.5, 0.0, 0.3, 0.5}) {
    for (const double kh : {1e-3, 0.1, 0.7, 2.5, 9.0, 35.0, 60.0, 1e4}) {
      const std::array layers{flat(1e-3, kRubber, nu)};
      const double k = kh / 1e-3;
      // At kh = 1e-3, the closed form of an incompressible layer loses six digits.
      const double tolerance = kh < 0.1 ? 1e-6 : 1e-11;
      EXPECT_LT(difference(flat_compliance(layers, k, 0.6), bonded_layer(1e-3, kRubber, nu, k)), tolerance)
          << nu << ' ' << kh;
    }
  }
}

TEST(FlatLayers, ThinLayerOnARigidBase) {
  const double h = 1e-3;
  const double k = 1e-4 / h;
  const std::array incompressible{flat(h, kRubber, 0.5)};
  const cplx thin = k * k * h * h * h / (3.0 * kRubber);
  EXPECT_LT(std::abs(flat_compliance(incompressible, k, 1.0).uu / thin - 1.0), 1e-7);  // 1 + O((kh)^2)
  const std::array compressible{flat(h, kRubber, 0.3)};
  const cplx confined = 2.0 * kRubber * 0.7 / 0.4;
  EXPECT_LT(std::abs(flat_compliance(compressible, k, 1.0).uu * confined / h - 1.0), 1e-7);
}

TEST(FlatLayers, LayerOnAHalfSpace) {
  for (const double kh : {1e-4, 0.01, 0.3, 1.0, 4.0, 15.0, 50.0}) {
    const std::array layers{flat(kInfinite, kStiff, 0.3), flat(2e-3, kRubber, 0.45)};
    const double k = kh / 2e-3;
    const cplx exact = layer_on_half_space(2e-3, kRubber, 0.45, kStiff, 0.3, k);
    EXPECT_LT(std::abs(flat_compliance(layers, k, 0.3).uu / exact - 1.0), 1e-12) << kh;
  }
}

TEST(FlatLayers, LayersOnAHalfSpaceOfTheirMaterialAgreeWithTheHalfSpace) {
  // With memory and inertia, this is the only exact test of the start of the recursion.
  for (const double nu : {0.2, 0.5}) {
    for (const double inertia : {0.0, 0.4e6, 2e6}) {
      for (const double k : {1.0, 100.0, 2e3, 1e5}) {
        for (const double cosine : {0.0, 0.7, 1.0}) {
          const std::array half_space{flat(kInfinite, kRubber, nu, inertia)};
          const std::array layers{half_space.front(), flat(3e-4, kRubber, nu, inertia),
                                  flat(2e-2, kRubber, nu, inertia)};
          EXPECT_LT(difference(flat_compliance(half_space, k, cosine), flat_compliance(layers, k, cosine)), 1e-12)
              << nu << ' ' << inertia << ' ' << k << ' ' << cosine;
        }
      }
    }
  }
}

TEST(FlatLayers, StaticHalfSpace) {
  const double nu = 0.3;
  const std::array half_space{flat(kInfinite, kRubber, nu)};
  const double k = 250.0;
  const cplx unit = 1.0 / (kRubber * k);
  const FlatCompliance exact{
      .uu = (1.0 - nu) * unit, .uk = -(1.0 - 2.0 * nu) / 2.0 * unit, .kk = (1.0 - nu) * unit, .pp = unit};
  EXPECT_LT(difference(flat_compliance(half_space, k, 1.0), exact), 1e-15);
}

Layer layer(double thickness, double density) {
  return {.thickness = thickness,
          .shear_modulus = standard_linear_solid(6e6, 3e6, 0.125),
          .poisson_ratio = 0.5,
          .density = density};
}

TEST(PlaneCompliance, CrossTermsAreOpposite) {
  const CoatedPlane plane{.layers = {layer(1e-3, 1000.0)},
                          .base = HalfSpace{.shear_modulus = Elastic{1e7}, .poisson_ratio = 0.3, .density = 2000.0}};
  const std::array xi{300.0, -300.0};
  const std::array zeta{200.0, -200.0};
  const auto c = surface_compliance(plane, 0.5, xi, zeta);
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t q = 0; q < 3; ++q) {
      const double sign = (p == 0) != (q == 0) ? -1.0 : 1.0;
      EXPECT_LT(std::abs(c[0][3 * p + q] - sign * c[0][3 * q + p]), 1e-20);
      EXPECT_EQ(c[1][3 * p + q], std::conj(c[0][3 * p + q]));  // real fields
    }
  }
  EXPECT_LT(c[0][0].imag(), 0.0);  // the displacement lags behind the load, towards growing xi
}

TEST(PlaneCompliance, CriticalSpeedIsThatOfRayleighWaves) {
  const double shear_wave = std::sqrt(6e6 / 1000.0);
  EXPECT_NEAR(critical_speed(CoatedPlane{.layers = {layer(1e-3, 1000.0)}}), 0.95531 * shear_wave, 1e-4 * shear_wave);
  // A soft half-space below a stiff layer of negligible mass.
  const CoatedPlane road{.layers = {{.thickness = 1e-3, .shear_modulus = Elastic{1e9}, .poisson_ratio = 0.3}},
                         .base = HalfSpace{.shear_modulus = Elastic{6e6}, .poisson_ratio = 0.5, .density = 1000.0}};
  EXPECT_NEAR(critical_speed(road), 0.95531 * shear_wave, 1e-4 * shear_wave);
  EXPECT_TRUE(std::isinf(critical_speed(CoatedPlane{.layers = {layer(1e-3, 0.0)}})));
  const std::array k{100.0};
  const std::array zero{0.0};
  try {
    std::ignore = surface_compliance(CoatedPlane{.layers = {layer(1e-3, 1000.0)}}, 80.0, k, zero);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("critical speed 73.99"), std::string::npos) << error.what();
  }
}

/// Largest difference between a spectrum and the recursion, relative to the entries as in test_modal.cpp.
double spectrum_error(const CoatedPlane& plane) {
  std::vector<double> orders;
  for (double m = 1e-4; m < 4e3; m *= 1.3) orders.push_back(m);
  const HarmonicBody harmonics(layered_body(plane, 0.021), 0.05 / 0.021, orders);
  const Observer observer;
  Watch watch(observer);
  const double highest_n = 4e3;
  const auto spectrum = make_spectrum(harmonics, highest_n, 1, watch);
  double error = 0.0;
  OrderSeries series;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    spectrum->series(i, series);
    for (const double n : {1e-5, 0.03, 1.0, 7.7, 60.0, 900.0, highest_n}) {
      const Eigen::ArrayXd one = Eigen::ArrayXd::Constant(1, n);
      const OrderValues values(orders[i], one, series);
      const Eigen::Matrix3cd exact = to_physical(harmonics.compliance({.i = i, .n = n}));
      Eigen::ArrayXcd value;
      for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t q = p; q < 3; ++q) {
          values.evaluate(entry_of(p, q).entry, value);
          const auto [row, column] = std::pair{static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)};
          const double size = std::sqrt(std::abs(exact(row, row)) * std::abs(exact(column, column)));
          error = std::max(error, std::abs(value[0] - exact(row, column)) / size);
        }
      }
    }
  }
  return error;
}

TEST(PlaneSpectrum, OneRelaxationFunction) { EXPECT_LT(spectrum_error({.layers = {layer(1e-3, 0.0)}}), 1e-10); }

TEST(PlaneSpectrum, DissimilarLayersWithInertia) {
  const CoatedPlane plane{
      .layers = {{.thickness = 2e-3, .shear_modulus = Elastic{2e6}, .bulk_modulus = 2e8}, layer(1e-3, 1000.0)},
      .base =
          HalfSpace{.shear_modulus = standard_linear_solid(3e7, 1e7, 1e-3), .poisson_ratio = 0.3, .density = 2000.0}};
  EXPECT_LT(spectrum_error(plane), 1e-10);
}

/// A. E. H. Love, Philosophical Transactions A 228 (1929) 377: displacement, per (1 - nu) / (2 pi G), of the surface of
/// a half-space at (x, z) from the middle of a rectangle 2 a x 2 b under a unit force.
double love(double x, double z, double a, double b) {
  const auto corner = [](double p, double q) {
    const double r = std::hypot(p, q);
    // This form of q ln(p + r) has no cancellation.
    const auto term = [r](double far, double near) {
      if (near == 0.0) return 0.0;
      return near * (far > 0.0 ? std::log(far + r) : 2.0 * std::log(std::abs(near)) - std::log(r - far));
    };
    return term(p, q) + term(q, p);
  };
  return (corner(x + a, z + b) - corner(x + a, z - b) - corner(x - a, z + b) + corner(x - a, z - b)) / (4.0 * a * b);
}

class PlaneTable : public testing::Test {
 protected:
  [[nodiscard]] Table normal_table(const CoatedPlane& plane, double angular_speed, double phi_shift = 0.0) {
    const CoatingSum sum(layered_body(plane, kRadius), angular_speed, mesh_, 1, watch_);
    return sum.tables({{.entry = Entry::rr, .phi_shift = phi_shift}}, kPhiReach, kThetaReach, 1, watch_).front();
  }

  static constexpr double kRadius = 0.021;
  static constexpr int kPhiReach = 60;
  static constexpr int kThetaReach = 30;
  Mesh mesh_{.nodes_per_revolution = 500, .max_order = {}, .theta_nodes_per_revolution = 400};
  double along_ = kRadius * phi_spacing(mesh_);
  double across_ = kRadius * theta_spacing(mesh_);
  Observer observer_;
  Watch watch_{observer_};
};

TEST_F(PlaneTable, HalfSpaceWithMemoryAgreesWithAMovingLoveRectangle) {
  const double tau = 0.125;
  const CoatedPlane plane{
      .layers = {}, .base = HalfSpace{.shear_modulus = standard_linear_solid(6e6, 3e6, tau), .poisson_ratio = 0.5}};
  for (const double angular_speed : {0.1, 2.5, 1000.0}) {
    const Table table = normal_table(plane, angular_speed);
    const double speed = angular_speed * kRadius;
    // The creep compliance is 1/G_0 + (1/G_inf - 1/G_0) (1 - exp(-t/T)) with T = tau G_0 / G_inf. A time t ago, the
    // material now at xi was at xi - V t.
    const double wake = speed * tau * 2.0;
    const auto creeping = [&](double xi, double zeta) {
      const auto at = [&](double x) { return love(x, zeta, 0.5 * along_, 0.5 * across_); };
      double sum = 0.0;
      constexpr int kIntervals = 40000;
      for (int i = 0; i < kIntervals; ++i) {  // midpoints of equal intervals of exp(-t/T)
        const double share = (i + 0.5) / kIntervals;
        sum += at(xi + wake * std::log(share)) / kIntervals;
      }
      return 0.5 / (2.0 * std::numbers::pi) * (at(xi) / 6e6 + (1.0 / 3e6 - 1.0 / 6e6) * sum);
    };
    const double center = table(0, 0);
    for (const auto& [j, l] : {std::pair{0, 0}, {1, 0}, {-1, 2}, {-40, 3}, {60, -30}, {-60, 30}}) {
      // 40 000 midpoints have an error of 1e-6 of the central value, even if the rectangle covers few of them.
      EXPECT_NEAR(table(j, l) / center, creeping(j * along_, l * across_) / center, 3e-6)
          << angular_speed << ' ' << j << ' ' << l;
    }
  }
}

TEST_F(PlaneTable, ElasticHalfSpaceAgreesWithLovesRectangle) {
  const double nu = 0.3;
  const CoatedPlane plane{.layers = {}, .base = HalfSpace{.shear_modulus = Elastic{1e7}, .poisson_ratio = nu}};
  const Table table = normal_table(plane, 1.0);
  const double scale = (1.0 - nu) / (2.0 * std::numbers::pi * 1e7);
  double worst = 0.0;
  for (int j = -kPhiReach; j <= kPhiReach; ++j) {
    for (int l = -kThetaReach; l <= kThetaReach; ++l) {
      worst =
          std::max(worst, std::abs(table(j, l) - scale * love(j * along_, l * across_, 0.5 * along_, 0.5 * across_)));
    }
  }
  // The sum ends at the last octave of a ball, which leaves this error.
  EXPECT_LT(worst / table(0, 0), 2e-8);
}

TEST_F(PlaneTable, MeasuredModulusAgreesWithItsModel) {
  const Prony model = standard_linear_solid(6e6, 3e6, 0.125);
  MasterCurve curve{.frequency = {}, .storage = {}, .loss = {}, .extrapolation = Extrapolation::hold};
  for (double omega = 1e-3; omega < 1e4; omega *= 1.02) {
    const std::array frequency{omega};
    const cplx value = complex_modulus(model, frequency).front();
    curve.frequency.push_back(omega);
    curve.storage.push_back(value.real());
    curve.loss.push_back(value.imag());
  }
  const auto plane = [](const ShearModulus& modulus) {
    return CoatedPlane{.layers = {{.thickness = 1e-3, .shear_modulus = modulus, .poisson_ratio = 0.5}}};
  };
  const Table measured = normal_table(plane(curve), 2.5);
  const Table exact = normal_table(plane(model), 2.5);
  for (int j = -kPhiReach; j <= kPhiReach; ++j) {
    // Linear interpolation in steps of 0.02 has an error of 0.02^2 / 8.
    EXPECT_NEAR(measured(j, 0) / exact(0, 0), exact(j, 0) / exact(0, 0), 1e-4);
  }
}

TEST_F(PlaneTable, NearlyIdenticalMaterialsAgreeWithIdenticalOnes) {
  // Two layers whose materials differ only in the last digits use another branch of the spectrum than two layers with
  // identical materials.
  const auto plane = [](double modulus) {
    CoatedPlane result{.layers = {layer(0.5e-3, 0.0), layer(0.5e-3, 0.0)}};
    result.layers.front().shear_modulus = standard_linear_solid(6e6, modulus, 0.125);
    return result;
  };
  const Table one = normal_table(plane(3e6), 2.5);
  const Table two = normal_table(plane(3e6 * (1.0 + 1e-11)), 2.5);
  for (int j = -kPhiReach; j <= kPhiReach; ++j) EXPECT_NEAR(one(j, 5) / one(0, 0), two(j, 5) / one(0, 0), 2e-9);
}

/// Surfaces of planes under the nodes of a ball.
class PlaneContact : public testing::Test {
 protected:
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> surface(const CoatedPlane& plane, double angular_speed,
                                                               bool is_counterbody = true) {
    const CoatingSum orders(layered_body(plane, grid_.radius), angular_speed, mesh_, 1, watch_);
    const Formulation formulation{.compliance = Compliance::radial,
                                  .patch_load = PatchLoad::flat,
                                  .tangential = true,
                                  .is_counterbody = is_counterbody};
    const auto tables = [&](const std::vector<TableRequest>& requests) {
      const WindowShape shape = window_.shape();
      return std::make_shared<const std::vector<Table>>(
          orders.tables(requests, shape.phi_nodes, shape.theta_nodes, 1, watch_));
    };
    return std::make_shared<TableOperator>(
        formulation, nodes_.grid(), nodes_.window(), tables(displacement_tables(formulation)),
        [dissipation = tables(dissipation_tables(formulation))](int, int) { return dissipation; },
        Execution{1, watch_});
  }

  Observer observer_;
  Watch watch_{observer_};
  Mesh mesh_{.nodes_per_revolution = 2000};
  SurfaceGrid grid_{.radius = 21e-3, .phi_spacing = phi_spacing(mesh_), .theta_spacing = theta_spacing(mesh_)};
  Window window_{{-52, 52}, {-52, 52}};
  SurfaceWindow nodes_{grid_, window_};
};

TEST_F(PlaneContact, EqualSurfacesHaveTwiceTheComplianceAndNoCrossTerms) {
  // The planes are mirror images of each other, so the sum is symmetric for any Poisson's ratio and memory, and its
  // normal and tangential compliances are those of one layer of half the modulus.
  const auto plane = [](double share) {
    Layer rubber = layer(1e-3, 0.0);
    rubber.shear_modulus = standard_linear_solid(share * 6e6, share * 3e6, 0.125);
    rubber.poisson_ratio = 0.3;
    return CoatedPlane{.layers = {rubber}};
  };
  const auto lower = surface(plane(1.0), 2.5);
  const auto soft = surface(plane(0.5), 2.5);
  const auto upper = surface(plane(1.0), 2.5, false);
  VectorField force = VectorField::Zero(window_.shape().size(), 3);
  const Eigen::Index middle = window_.number_of(0, 0);
  force(middle, kDown) = -1.0;
  const SumOperator sum(lower, lower);
  EXPECT_LT((sum.displacement(force) - soft->displacement(force)).abs().maxCoeff(),
            1e-13 * soft->displacement(force).abs().maxCoeff());
  const auto pair = SumOperator(upper, lower);
  const LocalCompliance& local = pair.local();
  for (int j = -50; j <= 50; ++j) {
    EXPECT_EQ(local.table(Entry::rphi)(j, 3), 0.0);
    EXPECT_EQ(local.table(Entry::rtheta)(j, 3), 0.0);
    EXPECT_NEAR(local.table(Entry::rr)(j, 3), soft->local().table(Entry::rr)(j, 3),
                1e-13 * local.table(Entry::rr)(0, 0));
  }
  EXPECT_GT(std::abs(lower->local().table(Entry::rphi)(2, 0)), 1e-3 * local.table(Entry::rr)(0, 0));
}

TEST(PatchSlope, DownstreamDisplacementsGiveThoseAtTheNodes) {
  constexpr Eigen::Index kRow = 2;
  constexpr Eigen::Index kRows = 12;
  const auto cubic = [](double row, Eigen::Index column) {
    return std::pow(row - 4.3, 3) - 2.0 * row * row + static_cast<double>(column);
  };
  for (const double downstream : {0.0, 0.07, 0.25}) {
    Eigen::ArrayXd values(kRows * kRow);
    Eigen::ArrayXd expected(kRows * kRow);
    for (Eigen::Index node = 0; node < values.size(); ++node) {
      const Eigen::Index number = node / kRow;
      const auto row = static_cast<double>(number);
      values[node] = cubic(row + downstream, node % kRow);
      expected[node] = cubic(row, node % kRow);
    }
    const Eigen::Index inner = (kRows - 3) * kRow;
    const Eigen::ArrayXd found = at_nodes(values, kRow, downstream);
    EXPECT_LT((found - expected).segment(2 * kRow, inner).abs().maxCoeff(), 1e-12 * expected.abs().maxCoeff());
    if (downstream == 0.0) EXPECT_TRUE((found == values).all());
  }
}

}  // namespace
}  // namespace viscoroll::detail
