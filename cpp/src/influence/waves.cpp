#include "influence/waves.hpp"

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

}  // namespace viscoroll::detail
