#include "influence/legendre.hpp"

#include <cmath>

namespace viscoroll::detail {
namespace {

constexpr int kBits = 512;  // a number is its mantissa times 2^(kBits exponent), the mantissa within 2^(+-kBits/2)

/// P_mm = sqrt((2m+1)!! / (2 (2m)!!)) sin^m, as mantissa and exponent.
void sectoral(int order, double sine, double& mantissa, int& exponent) {
  double log2 = -0.5;
  for (int i = 1; i <= order; ++i) log2 += 0.5 * std::log2(1.0 + 0.5 / i);
  log2 += order * std::log2(sine);
  exponent = static_cast<int>(std::floor(log2 / kBits + 0.5));
  mantissa = std::exp2(log2 - kBits * static_cast<double>(exponent));
}

}  // namespace

LegendreFunctions::LegendreFunctions(int order, int highest, const Eigen::ArrayXd& theta)
    : value(highest - order + 1, theta.size()), slope(highest - order + 1, theta.size()) {
  const double limit = std::exp2(kBits / 2);
  const double down = std::exp2(-kBits);
  const double m2 = static_cast<double>(order) * order;
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    // cos by way of the distance from the equator, where all nodes are.
    const double cosine = std::cos(theta[i]);
    const double sine = std::sin(theta[i]);
    double before = 0.0;
    double current = 0.0;
    int exponent = 0;
    sectoral(order, sine, current, exponent);
    for (int l = order; l <= highest; ++l) {
      const Eigen::Index row = l - order;
      const double degree = l;
      const double gap = degree * degree - m2;  // l^2 - m^2
      const double p = exponent == 0 ? current : 0.0;
      const double q = exponent == 0 ? before : 0.0;
      value(row, i) = p;
      slope(row, i) =
          (degree * cosine * p - std::sqrt(gap * (2.0 * degree + 1.0) / std::max(1.0, 2.0 * degree - 1.0)) * q) / sine;
      const double next_degree = degree + 1.0;
      const double a = std::sqrt((4.0 * next_degree * next_degree - 1.0) / (next_degree * next_degree - m2));
      const double b = l > order ? std::sqrt(gap / (4.0 * degree * degree - 1.0)) : 0.0;
      const double next = a * (cosine * current - b * before);
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
