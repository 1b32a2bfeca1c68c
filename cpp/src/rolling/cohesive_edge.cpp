#include "rolling/cohesive_edge.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using std::numbers::pi;

/// Degree of the polynomials in the square root of the distance from the edge.
constexpr Index kDegree = 16;

/// Linear functionals of functions that are polynomials in r = sqrt(s), s being the distance from the edge of the
/// contact relative to the length of the zone. Columns belong to the values at the nodes.
struct ZoneOperators {
  VectorXd r;             ///< Chebyshev's nodes, from 0 to 1
  MatrixXd slope;         ///< derivative with respect to r
  MatrixXd elastic;       ///< gap per compliance of a traction whose pressure has no singularity at s = 0
  RowVectorXd intensity;  ///< sqrt(2 / pi) integral of s^(-1/2)
  RowVectorXd moment;     ///< integral of s^(1/2)
};

/// Weight of a node in the barycentric formula.
double barycentric_weight(Index node) {
  return (node % 2 == 0 ? 1.0 : -1.0) * (node == 0 || node == kDegree ? 0.5 : 1.0);
}

/// Values of Lagrange's polynomials of Chebyshev's nodes at a point, by the barycentric formula.
RowVectorXd polynomials(const VectorXd& nodes, double at) {
  RowVectorXd values(nodes.size());
  for (Index j = 0; j < nodes.size(); ++j) {
    if (at == nodes[j]) return RowVectorXd::Unit(nodes.size(), j);
    values[j] = barycentric_weight(j) / (at - nodes[j]);
  }
  return values / values.sum();
}

/// Integrate a function from 0 to a length by the double exponential rule.
/// @param[in] function function of the distance from either end
template <class Function>
RowVectorXd integral(double length, const Function& function) {
  constexpr double kStep = 0.0625;
  constexpr int kSteps = 48;
  RowVectorXd sum = RowVectorXd::Zero(kDegree + 1);
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double y = pi * std::sinh(kStep * i);
    const double low = 1.0 / (1.0 + std::exp(-y));
    const double high = 1.0 / (1.0 + std::exp(y));
    sum += kStep * pi * std::cosh(kStep * i) * low * high * length * function(length * low, length * high);
  }
  return sum;
}

ZoneOperators make_operators() {
  constexpr Index kCount = kDegree + 1;
  ZoneOperators zone;
  zone.r = 0.5 - 0.5 * (ArrayXd::LinSpaced(kCount, 0.0, pi)).cos();
  const VectorXd& r = zone.r;
  zone.slope = MatrixXd::Zero(kCount, kCount);
  for (Index i = 0; i < kCount; ++i) {
    for (Index j = 0; j < kCount; ++j) {
      if (i == j) continue;
      zone.slope(i, j) = barycentric_weight(j) / (barycentric_weight(i) * (r[i] - r[j]));
      zone.slope(i, i) -= zone.slope(i, j);
    }
  }
  zone.intensity =
      std::sqrt(2.0 / pi) * integral(1.0, [&](double q, double) -> RowVectorXd { return 2.0 * polynomials(r, q); });
  zone.moment = integral(1.0, [&](double q, double) -> RowVectorXd { return 2.0 * q * q * polynomials(r, q); });
  zone.elastic = MatrixXd::Zero(kCount, kCount);
  for (Index i = 1; i < kCount; ++i) {
    // 4 sqrt(s / t) / pi - 2 ln|(sqrt(s) + sqrt(t)) / (sqrt(s) - sqrt(t))| / pi, with dt = 2 q dq
    const auto part = [&](double q, double distance) -> RowVectorXd {
      return (8.0 * r[i] - 4.0 * q * std::log((r[i] + q) / distance)) / pi * polynomials(r, q);
    };
    zone.elastic.row(i) = integral(r[i], [&](double q, double distance) { return part(q, distance); });
    if (i == kDegree) continue;
    zone.elastic.row(i) +=
        integral(1.0 - r[i], [&](double distance, double) { return part(r[i] + distance, distance); });
  }
  return zone;
}

const ZoneOperators& operators() {
  static const ZoneOperators kOperators = make_operators();
  return kOperators;
}

/// Creep of the gap of an opening edge, or of the strain of a closing edge, relative to the relaxed compliance. The
/// integral h of exp(-(t - t') / lambda) dv satisfies h' + 2 r h T / lambda = v' at the opening edge, and
/// h' - 2 r h T / lambda = v' at the closing edge, with h = 0 where material enters the zone.
/// @param[in] time time of passage T [s]
/// @param[in] opens whether material enters at r = 0, not at r = 1
MatrixXd creeping(const EdgeCreep& creep, double time, bool opens) {
  const ZoneOperators& zone = operators();
  const Index entry = opens ? 0 : kDegree;
  const double direction = opens ? 1.0 : -1.0;
  MatrixXd sum = MatrixXd::Identity(kDegree + 1, kDegree + 1);
  MatrixXd right = zone.slope;
  right.row(entry).setZero();
  for (std::size_t j = 0; j < creep.delayed.size(); ++j) {
    const double rate = time / creep.retardation_times[j];
    if (std::isinf(rate)) continue;
    MatrixXd left = zone.slope;
    left.diagonal() += 2.0 * direction * rate * zone.r;
    left.row(entry) = RowVectorXd::Unit(kDegree + 1, entry);
    sum -= creep.delayed[j] / creep.relaxed() * left.partialPivLu().solve(right);
  }
  return sum;
}

/// Solve phi = (1 - g / g(1))^2 for the traction phi by Newton's method, where g = gap phi + B displacement.
/// @param[in] gap gap of a traction relative to the relaxed compliance
/// @param[in] intensity stress intensity of a traction
/// @param[in] moment integral of s^(1/2) of a traction
/// @param[in] displacement gap of the pressure sqrt(r) relative to the relaxed compliance
/// @param[in] regular B / K
CohesiveEdge solve_zone(const MatrixXd& gap, const RowVectorXd& intensity, const RowVectorXd& moment,
                        const VectorXd& displacement, double regular) {
  constexpr int kMaxSteps = 50;  // less than ten are usual
  constexpr double kTolerance = 1e-12;
  double norm = 0.0;
  VectorXd traction = (1.0 - operators().r.array().square()).square();
  for (int step = 0; step < kMaxSteps; ++step) {
    // K^2 at the effective edge is that of the traction, plus 4 B times its moment (J integral).
    const double at_edge = intensity * traction;
    const double shift = 2.0 * regular * (moment * traction).value();
    const double root = std::hypot(shift, at_edge);
    const double total = shift + root;
    const RowVectorXd change_of_total =
        2.0 * regular * moment + (2.0 * regular * shift * moment + at_edge * intensity) / root;
    const VectorXd g = gap * traction + regular * total * displacement;
    const MatrixXd change = gap + regular * displacement * change_of_total;
    const double end = g[kDegree];
    const ArrayXd rest = 1.0 - g.array() / end;
    const VectorXd residual = traction.array() - rest.square();
    norm = residual.lpNorm<Eigen::Infinity>();
    if (norm < kTolerance) return {.work = end / 3.0, .intensity = total};
    const MatrixXd slope = (change - g / end * change.row(kDegree)) / end;
    MatrixXd newton = (2.0 * rest).matrix().asDiagonal() * slope;
    newton.diagonal().array() += 1.0;
    traction -= newton.partialPivLu().solve(residual);
  }
  throw ConvergenceError(
      "the traction in the cohesive zone of an edge did not converge; change the strength or the speed", kMaxSteps,
      norm);
}

/// Gap that the pressure sqrt(r) ahead of an edge causes behind it, per compliance: that of Hertz's contact.
VectorXd regular_displacement() { return 4.0 / 3.0 * operators().r.array().cube(); }

}  // namespace

double EdgeCreep::relaxed() const { return std::accumulate(delayed.begin(), delayed.end(), instantaneous); }

double EdgeCreep::after(double time) const {
  double value = instantaneous;
  for (std::size_t j = 0; j < delayed.size(); ++j) value -= delayed[j] * std::expm1(-time / retardation_times[j]);
  return value;
}

CohesiveEdge opening_edge(const EdgeCreep& creep, double time, double regular) {
  const ZoneOperators& zone = operators();
  const MatrixXd gap = creeping(creep, time, true);
  const auto [work, intensity] =
      solve_zone(gap * zone.elastic, zone.intensity, zone.moment, gap * regular_displacement(), regular);
  return {.work = creep.relaxed() * work, .intensity = intensity};
}

CohesiveEdge closing_edge(const EdgeCreep& creep, double time, double regular) {
  const ZoneOperators& zone = operators();
  const MatrixXd strain = creeping(creep, time, false);
  const auto [work, intensity] =
      solve_zone(zone.elastic * strain, zone.intensity * strain, zone.moment * strain, regular_displacement(), regular);
  return {.work = creep.relaxed() * work, .intensity = creep.relaxed() * intensity};
}

}  // namespace viscoroll::detail
