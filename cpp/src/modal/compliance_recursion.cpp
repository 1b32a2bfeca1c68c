#include "modal/compliance_recursion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace viscoroll::detail {
namespace {

constexpr double kDepth = 30.0;        // exponent beyond which material is out of reach of the surface
constexpr double kStepExponent = 1.5;  // largest exponent of a step: Taylor terms cancel little
constexpr double kStepRatio = 0.25;    // largest relative growth of the radius in a step: the series' radius is 1
constexpr int kMaxTerms = 60;          // 0.25^30 and 1.5^25/25! are both below round-off

template <class Scalar>
using Columns = Eigen::Matrix<Scalar, 6, 3>;

/// Solution at r (1 + x) of the layer's equations that starts as `start` at r.
///
/// (1 + x) dz/dx = (B + q (1 + x)^2 M) z with q = rho Omega^2 r^2 gives the terms t_j = z_j x^j by
/// t_{j+1} = x / (j+1) ((B - j) t_j + q M (t_j + 2 x t_{j-1} + x^2 t_{j-2})).
template <class Scalar>
Columns<Scalar> advance(const Matrix6<Scalar>& elastic, const Eigen::Matrix3d& inertia, const Columns<Scalar>& start,
                        double x) {
  const bool has_inertia = !inertia.isZero(0.0);
  Columns<Scalar> sum = start;
  Columns<Scalar> term = start;
  Columns<Scalar> before = Columns<Scalar>::Zero();
  Columns<Scalar> before_that = Columns<Scalar>::Zero();
  for (int j = 0; j < kMaxTerms; ++j) {
    Columns<Scalar> next = elastic * term - static_cast<double>(j) * term;
    if (has_inertia) {
      const Matrix3<Scalar> weighted = term.template topRows<3>() + 2.0 * x * before.template topRows<3>() +
                                       x * x * before_that.template topRows<3>();
      next.template bottomRows<3>() += inertia.template cast<Scalar>() * weighted;
    }
    next *= x / (j + 1);
    sum += next;
    // Entry by entry, since the normal compliance of a thin incompressible layer is far smaller than its neighbors; and
    // two terms in a row, since one alone may vanish by parity.
    const auto negligible = [&sum](const Columns<Scalar>& t) {
      return (t.cwiseAbs().array() <= 1e-17 * sum.cwiseAbs().array()).all();
    };
    if (negligible(next) && negligible(term)) break;
    before_that = before;
    before = term;
    term = next;
  }
  return sum;
}

/// Carry Y, in units of 1 / stress_unit, through all layers; `visit` sees it after every step and may stop by false.
template <class Scalar, class Visit>
Matrix3<Scalar> carry(std::span<const Medium<Scalar>> media, double m, double n, double stress_unit, Visit visit) {
  const double order = std::hypot(m, n);
  const double surface = media.back().outer_radius;
  const double deepest = surface * std::exp(-kDepth / std::max(order, 1e-300));
  Matrix3<Scalar> compliance = Matrix3<Scalar>::Zero();
  for (const Medium<Scalar>& medium : media) {
    if (medium.outer_radius <= deepest) continue;
    const double inner = std::max(medium.inner_radius, deepest);
    const double extent = std::log1p((medium.outer_radius - inner) / inner);
    const double longest = std::min(std::log1p(kStepRatio), kStepExponent / (order + 1.0));
    const int steps = static_cast<int>(std::ceil(extent / longest));
    const double x = std::expm1(extent / steps);
    const Matrix6<Scalar> elastic = elastic_matrix(medium, m, n, stress_unit);
    for (int step = 0; step < steps; ++step) {
      const double radius = inner * std::exp(extent * step / steps);
      const Eigen::Matrix3d inertia = medium.inertia * radius * radius / stress_unit * inertia_matrix(m);
      Columns<Scalar> state;
      state << compliance, Matrix3<Scalar>::Identity();
      state = advance<Scalar>(elastic, inertia, state, x);
      compliance = state.template topRows<3>() * state.template bottomRows<3>().inverse();
      if (!visit(compliance)) return compliance;
    }
  }
  return compliance;
}

template <class Scalar>
double stress_unit(std::span<const Medium<Scalar>> media) {
  return std::abs(media.back().mu);
}

}  // namespace

template <class Scalar>
Matrix3<Scalar> surface_compliance(std::span<const Medium<Scalar>> media, double m, double n) {
  const double unit = stress_unit(media);
  const Matrix3<Scalar> compliance = carry(media, m, n, unit, [](const Matrix3<Scalar>&) { return true; });
  return compliance * (media.back().outer_radius / unit);
}

bool is_subcritical(std::span<const Medium<double>> media, double m, double n) {
  bool positive = true;
  carry(media, m, n, stress_unit(media), [&](const Eigen::Matrix3d& compliance) {
    positive = compliance.llt().info() == Eigen::Success;
    return positive;
  });
  return positive;
}

template Matrix3<double> surface_compliance(std::span<const Medium<double>>, double, double);
template Matrix3<std::complex<double>> surface_compliance(std::span<const Medium<std::complex<double>>>, double,
                                                          double);

}  // namespace viscoroll::detail
