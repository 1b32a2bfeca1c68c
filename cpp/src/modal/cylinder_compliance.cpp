#include "modal/cylinder_compliance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "modal/critical_speed.hpp"

namespace viscoroll::detail {
namespace {

constexpr double kDepth = 24.0;        // exponent beyond which material is out of reach of the surface
constexpr double kStepExponent = 4.0;  // largest exponent of a step: Taylor terms cancel little
constexpr double kStepRatio = 0.25;    // largest relative growth of the radius in a step: the series' radius is 1
constexpr int kMaxTerms = 81;          // of a series; steps are short enough for 40
constexpr double kRoundOff = 1e-17;    // of a term that is left out, relative to the sum

/// Equations of some displacements and as many stresses, in units of the layer's modulus: z' = (B + q M) z in ln r.
template <class Scalar, int Components>
struct Equations {
  Eigen::Matrix<Scalar, 2 * Components, 2 * Components> elastic;  ///< B
  Eigen::Matrix<double, Components, Components> inertia;          ///< M, from displacements to stresses
};

template <class Scalar>
Equations<Scalar, 2> in_plane(const Scalar& b, double m) {
  const Scalar a = 1.0 - 2.0 * b;
  const Scalar epsilon = 4.0 * (1.0 - b);
  Equations<Scalar, 2> equations;
  equations.elastic << -a, m * a, b, 0.0,           //
      -m, 1.0, 0.0, 1.0,                            //
      epsilon, -m * epsilon, a, m,                  //
      -m * epsilon, m * m * epsilon, -m * a, -1.0;  //
  equations.inertia << -1.0 - m * m, 2.0 * m, 2.0 * m, -1.0 - m * m;
  return equations;
}

template <class Scalar>
Equations<Scalar, 1> along_axis(double m) {
  Equations<Scalar, 1> equations;
  equations.elastic << 0.0, 1.0, m * m, 0.0;
  equations.inertia << -m * m;
  return equations;
}

/// Carry the compliance Y over a step from r to r (1 + x) by the Taylor series of the solutions that start as (Y; 1):
/// t_{j+1} = x / (j+1) ((B - j) t_j + q M (t_j + 2 x t_{j-1} + x^2 t_{j-2})).
template <class Scalar, int Components>
void advance(const Equations<Scalar, Components>& equations, const Scalar& q, double x,
             Eigen::Matrix<Scalar, Components, Components>& compliance) {
  using Solutions = Eigen::Matrix<Scalar, 2 * Components, Components>;
  Solutions term;
  term << compliance, Eigen::Matrix<Scalar, Components, Components>::Identity();
  Solutions before = Solutions::Zero();
  Solutions before_that = Solutions::Zero();
  Solutions sum = term;
  int negligible = 0;  // terms in a row: one alone may vanish by parity
  for (int j = 0; j < kMaxTerms && negligible < 2; ++j) {
    Solutions next = equations.elastic * term - static_cast<double>(j) * term;
    next.template bottomRows<Components>() +=
        q * equations.inertia * (term + 2.0 * x * before + x * x * before_that).template topRows<Components>();
    next *= x / (j + 1);
    sum += next;
    negligible = (next.cwiseAbs().array() <= kRoundOff * sum.cwiseAbs().array()).all() ? negligible + 1 : 0;
    before_that = before;
    before = term;
    term = next;
  }
  compliance = sum.template topRows<Components>() * sum.template bottomRows<Components>().inverse();
}

/// Radius below which material is out of reach: solutions fall like r^(m-1) with depth at least, those of low orders
/// hold on to the core from any depth; inertia slows the decay of shear waves.
template <class Scalar>
double deepest_radius(std::span<const Medium<Scalar>> media, double m) {
  constexpr double kLeastDecay = 0.05;
  double left = kDepth;
  for (auto medium = media.rbegin(); medium != media.rend(); ++medium) {
    const std::complex<double> q = medium->inertia * medium->outer_radius * medium->outer_radius / medium->mu;
    const double decay = std::clamp(std::sqrt(1.0 - q).real(), kLeastDecay, 1.0);
    const double rate = std::max((m - 1.0) * decay, 1e-300);
    const double reach = medium->outer_radius * std::exp(-left / rate);
    if (reach >= medium->inner_radius) return reach;
    left -= rate * std::log(medium->outer_radius / medium->inner_radius);
  }
  return 0.0;
}

/// Y in units of radius per modulus of the layer, on its way outwards.
template <class Scalar>
class Recursion {
 public:
  Recursion(std::span<const Medium<Scalar>> media, double m) : media_(media), m_(m) {}

  /// `visit` sees the compliances after every step and may stop by false.
  template <class Visit>
  bool carry(const Visit& visit) {
    const double deepest = deepest_radius(media_, m_);
    for (std::size_t layer = 0; layer < media_.size(); ++layer) {
      const Medium<Scalar>& medium = media_[layer];
      if (layer > 0) {
        in_plane_ *= medium.mu / media_[layer - 1].mu;
        axial_ *= medium.mu / media_[layer - 1].mu;
      }
      double radius = std::min(std::max(medium.inner_radius, deepest), medium.outer_radius);
      const double extent = std::log1p((medium.outer_radius - radius) / radius);
      const double longest = std::min(std::log1p(kStepRatio), kStepExponent / (m_ + 1.0));
      const int steps = static_cast<int>(std::ceil(extent / longest));
      const double growth = std::expm1(extent / std::max(steps, 1));
      const auto plane = in_plane(medium.b, m_);
      const auto axis = along_axis<Scalar>(m_);
      for (int step = 0; step < steps; ++step, radius *= 1.0 + growth) {
        const Scalar q = medium.inertia * radius * radius / medium.mu;
        advance<Scalar, 2>(plane, q, growth, in_plane_);
        advance<Scalar, 1>(axis, q, growth, axial_);
        if (!visit(in_plane_, axial_(0, 0))) return false;
      }
    }
    return true;
  }

  [[nodiscard]] LineCompliance<Scalar> surface() const {
    const Scalar unit = media_.back().outer_radius / media_.back().mu;
    return {.normal = unit * in_plane_(0, 0),
            .mixed = unit * in_plane_(0, 1),
            .along = unit * in_plane_(1, 1),
            .axial = unit * axial_(0, 0)};
  }

 private:
  std::span<const Medium<Scalar>> media_;
  double m_;
  Eigen::Matrix<Scalar, 2, 2> in_plane_ = Eigen::Matrix<Scalar, 2, 2>::Zero();
  Eigen::Matrix<Scalar, 1, 1> axial_ = Eigen::Matrix<Scalar, 1, 1>::Zero();
};

}  // namespace

template <class Scalar>
LineCompliance<Scalar> cylinder_compliance(std::span<const Medium<Scalar>> media, double m) {
  Recursion<Scalar> recursion(media, m);
  recursion.carry([](const auto&, const Scalar&) { return true; });
  return recursion.surface();
}

bool is_subcritical(std::span<const Medium<double>> media, double m) {
  return Recursion<double>(media, m).carry(
      [](const Eigen::Matrix2d& y, double axial) { return y(0, 0) > 0.0 && y.determinant() > 0.0 && axial > 0.0; });
}

std::vector<Medium<std::complex<double>>> cylinder_media(const CoatedCylinder& cylinder,
                                                         std::span<const std::complex<double>> moduli,
                                                         double angular_speed) {
  std::vector<Medium<std::complex<double>>> media;
  double radius = cylinder.core_radius;
  for (std::size_t layer = 0; layer < cylinder.layers.size(); ++layer) {
    const Layer& material = cylinder.layers[layer];
    const double inner = std::exchange(radius, radius + material.thickness);
    media.push_back({.inner_radius = inner,
                     .outer_radius = radius,
                     .mu = moduli[layer],
                     .b = shear_ratio(material, moduli[layer]),
                     .inertia = material.density * angular_speed * angular_speed});
  }
  return media;
}

LineSpectrum cylinder_spectrum(const CoatedCylinder& cylinder, double angular_speed, const std::vector<double>& orders,
                               double measured_order, int threads, Watch& watch) {
  constexpr std::size_t kBlock = 16;  // orders that are solved in a row
  const auto moduli = harmonic_moduli(cylinder.layers, angular_speed, orders, measured_order);
  require_subcritical(cylinder, angular_speed, highest_frequency(angular_speed, orders, measured_order));
  require_damped_waves(cylinder, angular_speed, orders, moduli);
  LineSpectrum spectrum(orders.size());
  parallel_for(
      (orders.size() + kBlock - 1) / kBlock, threads, watch, "solving layers", [&](std::size_t block, const Worker&) {
        std::vector<std::complex<double>> at_order(moduli.size());
        for (std::size_t i = block * kBlock; i < std::min((block + 1) * kBlock, orders.size()); ++i) {
          for (std::size_t layer = 0; layer < moduli.size(); ++layer) at_order[layer] = moduli[layer][i];
          spectrum[i] =
              cylinder_compliance<std::complex<double>>(cylinder_media(cylinder, at_order, angular_speed), orders[i]);
        }
      });
  return spectrum;
}

template LineCompliance<double> cylinder_compliance(std::span<const Medium<double>>, double);
template LineCompliance<std::complex<double>> cylinder_compliance(std::span<const Medium<std::complex<double>>>,
                                                                  double);

}  // namespace viscoroll::detail
