#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "influence/order_bands.hpp"
#include "modal/layer_system.hpp"
#include "modal/order_panels.hpp"
#include "modal/spectrum.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Wide = std::complex<long double>;
using Wide3 = Eigen::Matrix<Wide, 3, 3>;
using Wide6 = Eigen::Matrix<Wide, 6, 6>;

/// Surface compliance with 64-bit mantissas, directly from the matrices of the equations: short steps of the full 6 x 6
/// system in phi and theta, from the bottom or from the depth that waves near the critical speed reach.
Eigen::Matrix3cd reference_compliance(const HarmonicBody& coating, std::size_t i, double n) {
  const double m = coating.orders()[i];
  const long double k = std::hypot(m, n);
  const long double deepest = coating.radius() * std::exp(-60.0L / k);
  const auto layers = coating.layers_at(i);
  const Wide unit(std::abs(layers.media.back().mu));
  Wide3 y = Wide3::Zero();
  bool started = false;
  for (const Medium<cplx>& medium : layers.media) {
    if (medium.outer <= deepest) continue;
    const long double inner = std::max<long double>(medium.inner, deepest);
    const long double extent = std::log(medium.outer / inner);
    const int steps = static_cast<int>(std::ceil(extent / std::min(0.1L, 0.7L / (k + 1.0L))));
    const long double x = std::expm1(extent / steps);
    Wide6 matrix = elastic_matrix(layers.metric, medium, m, n).cast<Wide>();
    matrix.topRightCorner<3, 3>() *= unit;
    matrix.bottomLeftCorner<3, 3>() /= unit;
    for (int step = 0; step < steps; ++step) {
      const long double radius = inner * std::exp(extent * step / steps);
      Wide6 inertia = Wide6::Zero();
      inertia.bottomLeftCorner<3, 3>() = inertia_matrix(m).cast<Wide>() * (medium.inertia * radius * radius / unit);
      Eigen::Matrix<Wide, 6, 3> sum = Eigen::Matrix<Wide, 6, 3>::Zero();
      const bool free = !started && layers.inner_boundary == InnerBoundary::hollow && inner == medium.inner;
      sum.topRows<3>() = free ? Wide3::Identity().eval() : y;
      sum.bottomRows<3>() = free ? Wide3::Zero().eval() : Wide3::Identity().eval();
      started = true;
      Eigen::Matrix<Wide, 6, 3> term = sum;
      Eigen::Matrix<Wide, 6, 3> before = Eigen::Matrix<Wide, 6, 3>::Zero();
      Eigen::Matrix<Wide, 6, 3> before_that = before;
      for (int j = 0; j < 32; ++j) {
        Eigen::Matrix<Wide, 6, 3> next = matrix * term - Wide(j) * term;
        next += inertia * (term + Wide(2.0L * x) * before + Wide(x * x) * before_that);
        next *= Wide(x / (j + 1));
        before_that = before;
        before = term;
        term = next;
        sum += term;
      }
      y = sum.topRows<3>() * sum.bottomRows<3>().inverse();
    }
  }
  return to_physical(Matrix3<cplx>((y * (Wide(coating.radius()) / unit)).cast<cplx>()));
}

/// Largest error of a spectrum at order (m, n), relative to the geometric mean of the diagonal entries of row and
/// column.
double error_at(const Spectrum& spectrum, const HarmonicBody& coating, std::size_t i, double n) {
  OrderSeries series;
  spectrum.series(i, series);
  const Eigen::ArrayXd orders = Eigen::ArrayXd::Constant(1, n);
  const OrderValues values(coating.orders()[i], orders, series);
  const Eigen::Matrix3cd exact = reference_compliance(coating, i, n);
  double error = 0.0;
  Eigen::ArrayXcd value;
  for (Eigen::Index p = 0; p < 3; ++p) {
    for (Eigen::Index q = 0; q < 3; ++q) {
      const SignedEntry entry = entry_of(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
      values.evaluate(entry.entry, value);
      const double size = std::sqrt(std::abs(exact(p, p) * exact(q, q)));
      error = std::max(error, std::abs(entry.sign * value[0] - exact(p, q)) / size);
    }
  }
  return error;
}

/// Random coatings of one to four dissimilar layers.
class RandomCoating {
 public:
  explicit RandomCoating(unsigned seed) : random_(seed) {}

  [[nodiscard]] CoatedSphere sphere(bool with_inertia) {
    const int count = integer(1, 4);
    const double outer = 21e-3;
    const auto boundary = static_cast<InnerBoundary>(integer(0, 2));
    const double thickness = boundary == InnerBoundary::solid ? outer : outer * logarithmic(1e-3, 0.9);
    CoatedSphere sphere{.core_radius = outer - thickness, .inner_boundary = boundary};
    for (int i = 0; i < count; ++i) {
      Layer layer{.thickness = thickness / count, .shear_modulus = modulus()};
      if (uniform(0.0, 1.0) < 0.3) {
        layer.bulk_modulus = logarithmic(1e7, 1e10);
      } else {
        layer.poisson_ratio = uniform(0.0, 1.0) < 0.3 ? 0.5 : uniform(0.0, 0.5);
      }
      if (with_inertia) layer.density = uniform(500.0, 3000.0);
      sphere.layers.push_back(std::move(layer));
    }
    if (boundary == InnerBoundary::solid) sphere.core_radius = 0.0;
    return sphere;
  }

  /// The same coating, in which one or more layers have moduli that are measured at up to 1e4 times `frequency`.
  [[nodiscard]] CoatedSphere measured_sphere(bool with_inertia, double frequency) {
    CoatedSphere sphere = this->sphere(with_inertia);
    const int first = integer(0, static_cast<int>(sphere.layers.size()) - 1);
    for (auto j = static_cast<std::size_t>(first); j < sphere.layers.size(); ++j) {
      sphere.layers[j].shear_modulus = measured_modulus(frequency);
    }
    return sphere;
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double logarithmic(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  ShearModulus modulus() {
    const double soft = logarithmic(1e5, 1e8);
    const double stiff = soft * logarithmic(1.1, 100.0);
    switch (integer(0, 3)) {
      case 0:
        return Prony{stiff, {0.3, 0.4}, {logarithmic(1e-4, 1.0), logarithmic(1e-4, 1.0)}};
      case 1:
        return FractionalZener{stiff, soft, logarithmic(1e-4, 1.0), uniform(0.2, 1.0)};
      case 2:
        return KelvinVoigt{soft, soft * logarithmic(1e-5, 1e-1)};
      default:
        return Elastic{soft};
    }
  }

  /// Noisy values with kinks: a table, linear in the logarithm of frequency, or a function that is linear in frequency.
  ShearModulus measured_modulus(double frequency) {
    const FractionalZener solid{logarithmic(1e7, 1e8), logarithmic(1e5, 1e7), logarithmic(1e-4, 1.0) / frequency, 0.7};
    MasterCurve curve{.extrapolation = Extrapolation::hold};
    const double step = std::pow(10.0, 1.0 / integer(1, 12));
    for (double w = 0.01 * frequency; w < 1e4 * frequency; w *= step * uniform(0.9, 1.1)) curve.frequency.push_back(w);
    for (const cplx mu : complex_modulus(solid, curve.frequency)) {
      curve.storage.push_back(mu.real() * uniform(0.95, 1.05));
      curve.loss.push_back(mu.imag() * uniform(0.8, 1.2));
    }
    if (integer(0, 1) == 0) return curve;
    return CustomModulus{[curve](std::span<const double> omega, std::span<cplx> modulus) {
      for (std::size_t i = 0; i < omega.size(); ++i) {
        const auto above = std::ranges::upper_bound(curve.frequency, omega[i]) - curve.frequency.begin();
        const auto last = static_cast<std::ptrdiff_t>(curve.frequency.size()) - 1;
        const auto high = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, last));
        const double width = curve.frequency[high] - curve.frequency[high - 1];
        const double t = std::clamp((omega[i] - curve.frequency[high - 1]) / width, 0.0, 1.0);
        modulus[i] = cplx(std::lerp(curve.storage[high - 1], curve.storage[high], t),
                          std::lerp(curve.loss[high - 1], curve.loss[high], t));
      }
    }};
  }

  std::mt19937 random_;
};

class RandomCoatings : public testing::TestWithParam<bool> {};

TEST_P(RandomCoatings, FastSpectraAgreeWithTheEquations) {
  const bool with_inertia = GetParam();
  const Observer observer;
  Watch watch(observer);
  int panels = 0;
  int refused = 0;
  std::vector<unsigned> seeds(16);
  std::iota(seeds.begin(), seeds.end(), 0U);
  // These seeds give waves that reach deep near the critical speed, and two thin shells without a core, whose inertia
  // series converges slowly.
  seeds.insert(seeds.end(), {28U, 48U, 144U});
  for (const unsigned seed : seeds) {
    RandomCoating random(seed);
    const CoatedSphere sphere = random.sphere(with_inertia);
    double speed = random.logarithmic(0.1, 100.0);
    if (with_inertia) {
      const double critical = critical_speed(sphere);
      speed = std::isfinite(critical) ? critical * random.logarithmic(0.05, 0.9) : random.logarithmic(1.0, 1e3);
    }
    const int nodes = random.integer(100, 4000);
    try {
      const HarmonicBody coating(layered_body(sphere), speed, all_orders(octaves(nodes)));
      const double highest_n = coating.orders().back();
      const auto spectrum = make_spectrum(coating, highest_n, 2, watch);
      panels += dynamic_cast<const OrderPanels*>(spectrum.get()) != nullptr;
      for (int sample = 0; sample < 25; ++sample) {
        const auto i = static_cast<std::size_t>(random.integer(1, static_cast<int>(coating.orders().size()) - 1));
        const double n = random.integer(0, 4) == 0 ? 0.0 : random.logarithmic(0.5, highest_n);
        if (coating.orders()[i] == 0.0) continue;
        EXPECT_LT(error_at(*spectrum, coating, i, n), 1e-10)
            << "coating " << seed << ", m = " << coating.orders()[i] << ", n = " << n << ", speed " << speed;
      }
    } catch (const std::invalid_argument&) {
      ++refused;  // weakly damped waves below the critical speed
    }
  }
  EXPECT_GT(panels, 9);
  EXPECT_LT(refused, 5);
}

/// Whether two series of an order agree to the last bit.
bool are_same(const OrderSeries& a, const OrderSeries& b) {
  return std::ranges::equal(a, b, [](const auto& p, const auto& q) { return p.low == q.low && p.series == q.series; });
}

TEST_P(RandomCoatings, MeasuredModuliAreSolvedBetweenTheirKinks) {
  const bool with_inertia = GetParam();
  const Observer observer;
  Watch watch(observer);
  int refused = 0;
  int samples = 0;
  int one_by_one = 0;
  for (unsigned seed = 0; seed < 16; ++seed) {
    RandomCoating random(seed);
    const double speed = random.logarithmic(0.1, 100.0);
    const CoatedSphere sphere = random.measured_sphere(with_inertia, speed);
    const Mesh mesh{.nodes_per_revolution = random.integer(100, 4000)};
    try {
      const LayeredBody body = layered_body(sphere);
      const HarmonicBody coating(body, speed, all_orders(phi_bands(body, speed, mesh)), measured_order(mesh));
      const double highest_n = theta_bands(body, speed, mesh).back().orders.maxCoeff();
      const auto spectrum = make_spectrum(coating, highest_n, 2, watch);
      const OrderByOrderSpectrum recursion(std::make_shared<const HarmonicBody>(coating), highest_n);
      for (int sample = 0; sample < 25; ++sample) {
        const auto i = static_cast<std::size_t>(random.integer(1, static_cast<int>(coating.orders().size()) - 1));
        const double n = random.integer(0, 4) == 0 ? 0.0 : random.logarithmic(0.5, highest_n);
        EXPECT_LT(error_at(*spectrum, coating, i, n), 1e-10)
            << "coating " << seed << ", m = " << coating.orders()[i] << ", n = " << n << ", speed " << speed;
        OrderSeries taken;
        OrderSeries solved;
        spectrum->series(i, taken);
        recursion.series(i, solved);
        ++samples;
        one_by_one += are_same(taken, solved);
      }
    } catch (const std::invalid_argument&) {
      ++refused;  // beyond the critical speed
    }
  }
  EXPECT_LT(refused, 5);
  EXPECT_LT(one_by_one, samples / 5);  // otherwise the panels would not save time
}

INSTANTIATE_TEST_SUITE_P(Inertia, RandomCoatings, testing::Bool(),
                         [](const auto& info) { return info.param ? "With" : "Without"; });

}  // namespace
}  // namespace viscoroll::detail
