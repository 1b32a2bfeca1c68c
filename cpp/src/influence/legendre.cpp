#include "influence/legendre.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace viscoroll::detail {
namespace {

constexpr int kBits = 512;  // a number is its mantissa times 2^(kBits exponent), with the mantissa within 2^(+-kBits/2)

/// log2 of P_mm = sqrt((2m+1)!! / (2 (2m)!!)) sin^m at sin = 1.
double sectoral_exponent(int order) {
  double log2 = -0.5;
  for (int i = 1; i <= order; ++i) log2 += 0.5 * std::log2(1.0 + 0.5 / i);
  return log2;
}

/// Coefficients of the recurrence P_(l+1) = next (cos P_l - before P_(l-1)) and of the slope.
struct Recursion {
  Eigen::ArrayXd next, before, slope;

  Recursion(int order, int highest) {
    const Eigen::ArrayXd l = Eigen::ArrayXd::LinSpaced(highest - order + 1, order, highest);
    const double m2 = static_cast<double>(order) * order;
    const Eigen::ArrayXd gap = l.square() - m2;
    next = ((4.0 * (l + 1.0).square() - 1.0) / ((l + 1.0).square() - m2)).sqrt();
    before = (gap / (4.0 * l.square() - 1.0)).max(0.0).sqrt();
    slope = (gap * (2.0 * l + 1.0) / (2.0 * l - 1.0).max(1.0)).sqrt();
  }
};

}  // namespace

std::pair<Eigen::ArrayXd, Eigen::ArrayXd> gauss_legendre(int points) {
  Eigen::VectorXd off(points - 1);
  for (Eigen::Index i = 0; i < off.size(); ++i) {
    const auto n = static_cast<double>(i + 1);
    off[i] = n / std::sqrt(4.0 * n * n - 1.0);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(points), off);
  return {solver.eigenvalues().array(), 2.0 * solver.eigenvectors().row(0).transpose().array().square()};
}

LegendreFunctions::LegendreFunctions(int order, int highest, const Eigen::ArrayXd& theta)
    : value(highest - order + 1, theta.size()), slope(highest - order + 1, theta.size()) {
  const double limit = std::exp2(kBits / 2);
  const double down = std::exp2(-kBits);
  const double at_equator = sectoral_exponent(order);
  const Recursion recursion(order, highest);
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    const double cosine = std::cos(theta[i]);
    const double sine = std::sin(theta[i]);
    const double log2 = at_equator + order * std::log2(sine);
    int exponent = static_cast<int>(std::floor(log2 / kBits + 0.5));
    double before = 0.0;
    double current = std::exp2(log2 - kBits * static_cast<double>(exponent));
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      const double p = exponent == 0 ? current : 0.0;
      const double q = exponent == 0 ? before : 0.0;
      value(row, i) = p;
      slope(row, i) = (static_cast<double>(order + row) * cosine * p - recursion.slope[row] * q) / sine;
      const double next = recursion.next[row] * (cosine * current - recursion.before[row] * before);
      before = current;
      current = next;
      if (std::abs(current) > limit) {
        current *= down;
        before *= down;
        ++exponent;
      }
    }
  }
}

}  // namespace viscoroll::detail
