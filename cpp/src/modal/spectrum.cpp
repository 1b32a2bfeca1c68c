#include "modal/spectrum.hpp"

#include <algorithm>
#include <array>

#include "modal/order_by_order.hpp"
#include "modal/self_similar.hpp"

namespace viscoroll::detail {
namespace {

/// values[i] = sum_j series[j] T_j(x[i]), by Clenshaw's recursion on blocks that the compiler vectorizes.
void sum_chebyshev(const std::array<double, kPanelNodes>& series, const double* x, double* values, Eigen::Index count) {
  constexpr int kBlock = 8;
  for (Eigen::Index start = 0; start < count; start += kBlock) {
    const auto length = std::min<Eigen::Index>(kBlock, count - start);
    std::array<double, kBlock> point{};
    std::array<double, kBlock> next{};
    std::array<double, kBlock> after_next{};
    std::copy_n(x + start, length, point.begin());
    for (std::size_t j = kPanelNodes - 1; j > 0; --j) {
      for (std::size_t i = 0; i < kBlock; ++i) {
        const double current = series[j] + 2.0 * point[i] * next[i] - after_next[i];
        after_next[i] = next[i];
        next[i] = current;
      }
    }
    for (std::size_t i = 0; i < kBlock; ++i) next[i] = series[0] + point[i] * next[i] - after_next[i];
    std::copy_n(next.begin(), length, values + start);
  }
}

}  // namespace

std::unique_ptr<Spectrum> make_spectrum(const HarmonicCoating& coating, int threads, Watch& watch) {
  if (auto shared = SelfSimilarSpectrum::try_make(coating, threads, watch)) return shared;
  return std::make_unique<OrderByOrderSpectrum>(coating);
}

void evaluate(int m, Entry entry, const OrderSeries& series, Eigen::Ref<Eigen::ArrayXcd> values) {
  const double m2 = static_cast<double>(m) * m;
  const Eigen::Index count = values.size();
  Eigen::ArrayXd coordinate(count);
  Eigen::ArrayXd part(count);

  Eigen::Index first = 0;
  for (const auto& panel : series) {
    Eigen::Index last = first;
    while (last < count && m2 + static_cast<double>(last) * static_cast<double>(last) <= panel.high) ++last;
    const Eigen::Index length = last - first;
    for (Eigen::Index i = 0; i < length; ++i) {
      const auto n = static_cast<double>(first + i);
      coordinate[i] = panel.coordinate(m2 + n * n);
    }
    const auto row = panel.series.row(static_cast<int>(entry));
    const auto add_part = [&](const auto& coefficients, std::complex<double> unit) {
      if (coefficients.isZero(0.0)) return;
      std::array<double, kPanelNodes> terms{};
      for (int j = 0; j < kPanelNodes; ++j) terms[static_cast<std::size_t>(j)] = coefficients(j);
      sum_chebyshev(terms, coordinate.data(), part.data(), length);
      values.segment(first, length) += unit * part.head(length);
    };
    values.segment(first, length).setZero();
    add_part(row.real(), {1.0, 0.0});
    add_part(row.imag(), {0.0, 1.0});
    first = last;
  }

  // From the real form to the components of the paper, and back the factor n of odd entries.
  if (is_odd(entry)) values *= Eigen::ArrayXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
  if (entry == Entry::rphi || entry == Entry::rtheta) values *= std::complex<double>(0.0, -1.0);
}

}  // namespace viscoroll::detail
