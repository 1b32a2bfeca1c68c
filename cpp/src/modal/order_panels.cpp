#include "modal/order_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "modal/compliance_recursion.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Cell = OrderPanels::Cell;
constexpr int kOrderNodes = OrderPanels::kOrderNodes;

constexpr double kLowestOrder = 2.0;        // orders below are few
constexpr double kLargestOrderRatio = 8.0;  // of m at the ends of a cell, over which a relaxation is resolved
constexpr double kSmallestRatio = 1.05;     // what a cell this narrow does not resolve is round-off

/// Compliance times m and the modulus of the outer layer, of entries odd in n divided by n / m, at the nodes of a cell:
/// a row for each m, columns as in `Cell::series`.
auto sample(const HarmonicCoating& coating, const Cell& cell) -> decltype(Cell::series) {
  const auto m = panel_nodes<kOrderNodes>(cell.lowest_m, cell.highest_m);
  const auto ratios = panel_nodes(cell.lowest_ratio, cell.highest_ratio);
  const HarmonicCoating at_nodes = coating.at({m.begin(), m.end()});

  std::vector<std::vector<Medium<cplx>>> media;
  for (std::size_t i = 0; i < m.size(); ++i) media.push_back(at_nodes.media(i));
  // Side by side are orders of like k.
  std::vector<OrderInLayers<cplx>> orders;
  for (const double ratio : ratios) {
    for (std::size_t i = 0; i < m.size(); ++i) {
      orders.push_back({.media = media[i], .m = m[i], .n = m[i] * std::sqrt(ratio - 1.0)});
    }
  }
  std::vector<Matrix3<cplx>> solved(orders.size());
  surface_compliances<cplx>(orders, solved);

  decltype(Cell::series) values;
  for (std::size_t j = 0; j < ratios.size(); ++j) {
    const double n_ratio = std::sqrt(ratios[j] - 1.0);
    for (std::size_t i = 0; i < m.size(); ++i) {
      const Matrix3<cplx> y = solved[j * m.size() + i] * (m[i] * media[i].back().mu);
      const std::array<cplx, kEntries> entries{y(0, 0), y(0, 1),           y(0, 2) / n_ratio,
                                               y(1, 1), y(1, 2) / n_ratio, y(2, 2)};
      for (std::size_t e = 0; e < kEntries; ++e) {
        values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(e * kPanelNodes + j)) = entries[e];
      }
    }
  }
  return values;
}

/// Whether the last two terms in each direction are negligible.
struct Resolution {
  bool along_m = true;
  bool along_k = true;
};

Resolution resolution(const Cell& cell) {
  const auto block = [&](int entry) { return cell.series.middleCols<kPanelNodes>(entry * kPanelNodes).cwiseAbs(); };
  const auto largest = [&](Entry entry) { return block(static_cast<int>(entry)).maxCoeff(); };
  const auto sizes = entry_sizes(largest(Entry::rr), largest(Entry::phiphi), 1.0, std::sqrt(cell.highest_ratio - 1.0));
  Resolution resolution;
  for (int entry = 0; entry < kEntries; ++entry) {
    const double limit = kSeriesTolerance * sizes[static_cast<std::size_t>(entry)];
    if (block(entry).bottomRows<2>().maxCoeff() > limit) resolution.along_m = false;
    if (block(entry).rightCols<2>().maxCoeff() > limit) resolution.along_k = false;
  }
  return resolution;
}

/// Append the cells that resolve the compliance on the range of `cell`, halved where needed.
void append_cells(const HarmonicCoating& coating, Cell cell, const Worker& worker, std::vector<Cell>& cells) {
  worker.checkpoint();
  const decltype(Cell::series) values = sample(coating, cell);
  for (int entry = 0; entry < kEntries; ++entry) {
    cell.series.middleCols<kPanelNodes>(entry * kPanelNodes) =
        chebyshev_transform<kOrderNodes>().transpose().cast<cplx>() *
        values.middleCols<kPanelNodes>(entry * kPanelNodes) * chebyshev_transform().cast<cplx>();
  }
  const Resolution resolved = resolution(cell);
  const auto is_wide = [](double low, double high) { return high / low > kSmallestRatio; };
  if (!resolved.along_k && is_wide(cell.lowest_ratio, cell.highest_ratio)) {
    const double middle = std::sqrt(cell.lowest_ratio * cell.highest_ratio);
    append_cells(coating, {cell.lowest_m, cell.highest_m, cell.lowest_ratio, middle, {}}, worker, cells);
    append_cells(coating, {cell.lowest_m, cell.highest_m, middle, cell.highest_ratio, {}}, worker, cells);
  } else if (!resolved.along_m && is_wide(cell.lowest_m, cell.highest_m)) {
    const double middle = std::sqrt(cell.lowest_m * cell.highest_m);
    append_cells(coating, {cell.lowest_m, middle, cell.lowest_ratio, cell.highest_ratio, {}}, worker, cells);
    append_cells(coating, {middle, cell.highest_m, cell.lowest_ratio, cell.highest_ratio, {}}, worker, cells);
  } else {
    cells.push_back(cell);
  }
}

/// T_0 ... T_23 of the coordinate of m in a cell.
Eigen::Matrix<double, 1, kOrderNodes> chebyshev_polynomials(const Cell& cell, double m) {
  const double x = 2.0 * std::log(m / cell.lowest_m) / std::log(cell.highest_m / cell.lowest_m) - 1.0;
  Eigen::Matrix<double, 1, kOrderNodes> values;
  values[0] = 1.0;
  values[1] = x;
  for (int i = 2; i < kOrderNodes; ++i) values[i] = 2.0 * x * values[i - 1] - values[i - 2];
  return values;
}

}  // namespace

OrderPanels::OrderPanels(const HarmonicCoating& coating, double highest_n, int threads, Watch& watch)
    : coating_(coating), one_by_one_(coating, highest_n) {
  std::vector<double> orders = coating.orders();
  std::sort(orders.begin(), orders.end());
  for (auto first = std::lower_bound(orders.begin(), orders.end(), kLowestOrder); first != orders.end();) {
    const auto end = std::upper_bound(first, orders.end(), kLargestOrderRatio * *first);
    if (end - first > kOrderNodes) {
      ranges_.push_back({.lowest_m = *first, .highest_m = *(end - 1), .cells = {}});
      first = end;
    } else {
      ++first;
    }
  }

  struct Part {
    std::size_t range;
    Cell cell;
    std::vector<Cell> cells;
  };
  std::vector<Part> parts;
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    const double highest = 1.0 + std::pow(highest_n / ranges_[r].lowest_m, 2);
    const double count = std::ceil(std::log(highest) / std::log(kLargestPanelRatio));
    for (double i = 0.0; i < count; ++i) {
      parts.push_back({.range = r,
                       .cell = {.lowest_m = ranges_[r].lowest_m,
                                .highest_m = ranges_[r].highest_m,
                                .lowest_ratio = std::pow(highest, i / count),
                                .highest_ratio = std::pow(highest, (i + 1.0) / count)}});
    }
  }
  parallel_for(parts.size(), threads, watch, "solving layers", [&](std::size_t p, const Worker& worker) {
    append_cells(coating_, parts[p].cell, worker, parts[p].cells);
  });
  for (Part& part : parts) {
    auto& cells = ranges_[part.range].cells;
    cells.insert(cells.end(), part.cells.begin(), part.cells.end());
  }
}

const OrderPanels::Range* OrderPanels::range_of(double m) const {
  const auto range = std::find_if(ranges_.begin(), ranges_.end(), [m](const Range& r) { return m <= r.highest_m; });
  return range != ranges_.end() && m >= range->lowest_m ? &*range : nullptr;
}

void OrderPanels::series(std::size_t i, OrderSeries& series) const {
  const double m = coating_.orders()[i];
  const Range* range = range_of(m);
  if (!range) return one_by_one_.series(i, series);

  const std::size_t outermost = coating_.sphere().layers.size() - 1;
  const cplx unit = 1.0 / (m * coating_.modulus(outermost, i));
  std::size_t used = 0;
  for (const Cell& cell : range->cells) {
    const bool is_last = cell.highest_m == range->highest_m;
    if (m < cell.lowest_m || (m >= cell.highest_m && !is_last)) continue;
    if (used == series.size()) series.emplace_back();
    auto& panel = series[used++];
    panel.low = m * m * cell.lowest_ratio;
    panel.high = m * m * cell.highest_ratio;
    const Eigen::Matrix<cplx, 1, kEntries * kPanelNodes> terms = chebyshev_polynomials(cell, m) * cell.series;
    panel.series.resize(kEntries, kPanelNodes);
    for (int entry = 0; entry < kEntries; ++entry) {
      const cplx factor = is_odd(static_cast<Entry>(entry)) ? unit / m : unit;
      panel.series.row(entry) = factor * terms.segment<kPanelNodes>(entry * kPanelNodes);
    }
  }
  series.resize(used);
}

}  // namespace viscoroll::detail
