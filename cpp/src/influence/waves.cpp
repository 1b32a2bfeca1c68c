#include "influence/waves.hpp"

#include <cmath>
#include <complex>

namespace viscoroll::detail {

Waves make_waves(const Eigen::ArrayXd& orders, double spacing, int last_offset) {
  using cplx = std::complex<double>;
  using Eigen::Index;
  constexpr int kStride = 32;  // number of products until a new evaluation limits the round-off
  Waves waves{RowMajorMatrix(orders.size(), last_offset + 1), RowMajorMatrix(orders.size(), last_offset + 1)};
  for (Index i = 0; i < orders.size(); ++i) {
    const cplx step = std::polar(1.0, orders[i] * spacing);
    cplx wave;
    for (Index l = 0; l <= last_offset; ++l) {
      wave = l % kStride == 0 ? std::polar(1.0, orders[i] * spacing * static_cast<double>(l)) : wave * step;
      waves.cosines(i, l) = wave.real();
      waves.sines(i, l) = wave.imag();
    }
  }
  return waves;
}

Waves make_waves(const Eigen::ArrayXd& orders, const Eigen::ArrayXd& offsets) {
  const Eigen::ArrayXXd phase = (orders.matrix() * offsets.matrix().transpose()).array();
  return {.cosines = phase.cos(), .sines = phase.sin()};
}

double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

double spherical_bessel(int degree, double x) {
  // The closed forms cancel at small x, where a short series is used.
  const double y = x * x;
  switch (degree) {
    case 0:
      return sinc(x);
    case 1:
      return std::abs(x) < 0.1 ? x / 3.0 * (1.0 - y / 10.0 * (1.0 - y / 28.0 * (1.0 - y / 54.0)))
                               : (std::sin(x) / x - std::cos(x)) / x;
    default:
      return std::abs(x) < 0.2 ? y / 15.0 * (1.0 - y / 14.0 * (1.0 - y / 36.0 * (1.0 - y / 66.0 * (1.0 - y / 104.0))))
                               : ((3.0 / y - 1.0) * std::sin(x) - 3.0 * std::cos(x) / x) / x;
  }
}

std::array<double, kPatchShapes> spherical_patch_weights(double theta, double spacing) {
  // Five Gauss points are exact to round-off on patches of a few degrees.
  constexpr std::array<double, 5> kPoints{-0.90617984593866399, -0.53846931010568309, 0.0, 0.53846931010568309,
                                          0.90617984593866399};
  constexpr std::array<double, 5> kWeights{0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                           0.47862867049936647, 0.23692688505618909};
  std::array<double, kPatchShapes> coefficients{};
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    const double x = kPoints[i];
    const std::array<double, kPatchShapes> legendre{1.0, x, 1.5 * x * x - 0.5};
    const double value = kWeights[i] / std::sin(theta + 0.5 * spacing * x);
    for (std::size_t p = 0; p < coefficients.size(); ++p) {
      coefficients[p] += (static_cast<double>(p) + 0.5) * value * legendre[p];
    }
  }
  return coefficients;
}

}  // namespace viscoroll::detail
