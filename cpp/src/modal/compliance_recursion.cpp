#include "modal/compliance_recursion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

constexpr double kDepth = 24.0;        // exponent beyond which material is out of reach of the surface
constexpr double kStepExponent = 1.5;  // largest exponent of a step: Taylor terms cancel little
constexpr double kStepRatio = 0.25;    // largest relative growth of the radius in a step: the series' radius is 1
constexpr int kMaxTerms = 60;          // 0.25^30 and 1.5^25/25! are both below round-off

/// Three solutions, one in each row.
template <class Scalar>
using States = Eigen::Array<Scalar, 3, 6>;

/// Largest part of a number: a size that costs no square root.
double size(double value) { return std::abs(value); }
double size(const std::complex<double>& value) { return std::max(std::abs(value.real()), std::abs(value.imag())); }

/// Entry by entry, since the normal compliance of a thin incompressible layer is far smaller than its neighbors.
template <class Scalar>
bool is_negligible(const States<Scalar>& term, const States<Scalar>& sum) {
  for (Eigen::Index i = 0; i < term.size(); ++i) {
    if (size(term.data()[i]) > 1e-17 * size(sum.data()[i])) return false;
  }
  return true;
}

/// Solutions at r (1 + x) of the layer's equations that start as `start` at r.
///
/// (1 + x) dz/dx = (B + q (1 + x)^2 M) z with q = rho Omega^2 r^2 gives the terms t_j = z_j x^j by
/// t_{j+1} = x / (j+1) ((B - j) t_j + q M (t_j + 2 x t_{j-1} + x^2 t_{j-2})).
template <class Scalar>
States<Scalar> advance(const LayerEquations<Scalar>& elastic, const Eigen::Matrix3d& inertia,
                       const States<Scalar>& start, double x) {
  const bool has_inertia = !inertia.isZero(0.0);
  const Matrix3<Scalar> transposed_inertia = inertia.transpose().template cast<Scalar>();
  States<Scalar> sum = start;
  States<Scalar> term = start;
  Matrix3<Scalar> before = Matrix3<Scalar>::Zero();  // displacements of the two terms before
  Matrix3<Scalar> before_that = Matrix3<Scalar>::Zero();
  for (int j = 0; j < kMaxTerms; ++j) {
    States<Scalar> next = elastic(term) - static_cast<double>(j) * term;
    if (has_inertia) {
      const Matrix3<Scalar> displacement = term.template leftCols<3>().matrix();
      const Matrix3<Scalar> weighted = displacement + 2.0 * x * before + x * x * before_that;
      next.template rightCols<3>() += (weighted * transposed_inertia).array();
      before_that = before;
      before = displacement;
    }
    next *= x / (j + 1);
    sum += next;
    // Two terms in a row: one alone may vanish by parity.
    if (is_negligible(next, sum) && is_negligible(term, sum)) break;
    term = next;
  }
  return sum;
}

/// Solutions that the innermost layer starts with at `inner`: three stresses on what carries it, or three displacements
/// of a free surface. A solid ball starts like one on a tiny core: what is not regular at the center dies out.
template <class Scalar>
States<Scalar> starting_states(const Medium<Scalar>& medium, double inner, double order) {
  States<Scalar> states = States<Scalar>::Zero();
  states.template rightCols<3>() = Matrix3<Scalar>::Identity().array();
  if (medium.within == InnerBoundary::hollow && inner == medium.inner_radius) {
    const Eigen::Index free = order > 0.0 ? 3 : 1;  // order (0, 0) leaves rotations of the whole coating free
    for (Eigen::Index i = 0; i < free; ++i) std::swap(states(i, i), states(i, i + 3));
  }
  return states;
}

/// Carry Y, in units of 1 / stress_unit, through all layers; `visit` sees it after every step and may stop by false.
template <class Scalar, class Visit>
Matrix3<Scalar> carry(std::span<const Medium<Scalar>> media, double m, double n, double stress_unit, Visit visit) {
  const double order = std::hypot(m, n);
  const double surface = media.back().outer_radius;
  // At order 0 what a rigid core holds reaches the surface from any depth; without one, only the uniform swelling does,
  // whose two solutions differ by the third power of the radius.
  const bool held = media.front().within == InnerBoundary::rigid;
  const double deepest = surface * std::exp(-kDepth / std::max(order, held ? 1e-300 : 0.5));
  Matrix3<Scalar> compliance = Matrix3<Scalar>::Zero();
  bool started = false;
  for (Medium<Scalar> medium : media) {
    if (medium.outer_radius <= deepest) continue;
    const double inner = std::max(medium.inner_radius, deepest);
    const double extent = std::log1p((medium.outer_radius - inner) / inner);
    const double longest = std::min(std::log1p(kStepRatio), kStepExponent / (order + 1.0));
    const int steps = static_cast<int>(std::ceil(extent / longest));
    const double x = std::expm1(extent / steps);
    medium.mu /= stress_unit;
    const LayerEquations<Scalar> elastic(medium, m, n);
    for (int step = 0; step < steps; ++step) {
      const double radius = inner * std::exp(extent * step / steps);
      const Eigen::Matrix3d inertia = medium.inertia * radius * radius / stress_unit * inertia_matrix(m);
      States<Scalar> states = starting_states(medium, inner, order);
      if (started) {
        states.template leftCols<3>() = compliance.transpose().array();
        states.template rightCols<3>() = Matrix3<Scalar>::Identity().array();
      }
      started = true;
      states = advance<Scalar>(elastic, inertia, states, x);
      // Rows are states: Y^T = F^-T D^T.
      const Matrix3<Scalar> displacement = states.template leftCols<3>().matrix();
      const Matrix3<Scalar> stress = states.template rightCols<3>().matrix();
      compliance = (stress.inverse() * displacement).transpose();
      if (!visit(compliance)) return compliance;
    }
  }
  if (!held && order == 0.0) compliance.template bottomRightCorner<2, 2>().setZero();  // no mean rotation
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
