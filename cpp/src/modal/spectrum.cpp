#include "modal/spectrum.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/instruction_sets.hpp"
#include "modal/order_panels.hpp"
#include "modal/self_similar.hpp"

namespace viscoroll::detail {
namespace {

/// Compute values[i] = sum_j series[j] T_j(x[i]) by Clenshaw's recursion on blocks that the compiler vectorizes.
VISCOROLL_BEST_INSTRUCTIONS
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

std::unique_ptr<Spectrum> make_spectrum(const HarmonicBody& body, double highest_n, int threads, Watch& watch,
                                        double inertia_tolerance) {
  if (auto shared = SelfSimilarSpectrum::try_make(body, highest_n, inertia_tolerance, threads, watch)) return shared;
  return std::make_unique<OrderPanels>(std::make_shared<const HarmonicBody>(body), highest_n, threads, watch);
}

OrderValues::OrderValues(double m, const Eigen::ArrayXd& n, const OrderSeries& series)
    : n_(n), series_(series), coordinate_(m * m + n.square()) {
  const Eigen::Index count = n.size();
  Eigen::Index first = 0;
  for (const auto& panel : series) {
    first_.push_back(first);
    const double* end = std::upper_bound(coordinate_.data() + first, coordinate_.data() + count, panel.high);
    const Eigen::Index last = &panel == &series.back() ? count : end - coordinate_.data();
    auto part = coordinate_.segment(first, last - first);
    if (panel.low > 0.0) {
      part = (part / panel.low).log() * (2.0 / std::log(panel.high / panel.low)) - 1.0;
    } else {
      part.setZero();
    }
    first = last;
  }
  first_.push_back(first);
}

void OrderValues::evaluate(Entry entry, Eigen::ArrayXcd& values) const {
  values.setZero(n_.size());
  Eigen::ArrayXd part(n_.size());
  for (std::size_t p = 0; p < series_.size(); ++p) {
    const Eigen::Index first = first_[p];
    const Eigen::Index length = first_[p + 1] - first;
    if (length == 0) continue;
    const auto row = series_[p].series.row(static_cast<int>(entry));
    const auto add_part = [&](const auto& coefficients, std::complex<double> unit) {
      if (coefficients.isZero(0.0)) return;
      std::array<double, kPanelNodes> terms{};
      for (int j = 0; j < kPanelNodes; ++j) terms[static_cast<std::size_t>(j)] = coefficients(j);
      sum_chebyshev(terms, coordinate_.data() + first, part.data(), length);
      values.segment(first, length) += unit * part.head(length);
    };
    add_part(row.real(), {1.0, 0.0});
    add_part(row.imag(), {0.0, 1.0});
  }

  // Restore the factor n of odd entries, and convert the real form to the components of the paper.
  if (is_odd(entry)) values *= n_;
  values *= phase_of(entry);
}

}  // namespace viscoroll::detail
