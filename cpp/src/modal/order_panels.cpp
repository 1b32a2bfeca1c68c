#include "modal/order_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "base/recent_cache.hpp"
#include "modal/harmonic_moduli.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Relative error of an interpolated modulus, that of the series of compliances.
constexpr double kModulusTolerance = 1e-13;

/// Whether the last two terms of the series of each entry are negligible.
bool is_resolved(const Panel<cplx>& panel, double m, double tolerance) {
  const auto largest = [&](Entry entry) { return panel.series.row(static_cast<int>(entry)).cwiseAbs().maxCoeff(); };
  const double highest_n = std::sqrt(panel.high - m * m);
  const auto sizes = entry_sizes(largest(Entry::rr), largest(Entry::phiphi), 1.0, highest_n);
  for (int entry = 0; entry < kEntries; ++entry) {
    const double last = panel.series.row(entry).tail<2>().cwiseAbs().maxCoeff();
    if (last > tolerance * sizes[static_cast<std::size_t>(entry)]) return false;
  }
  return true;
}

using Cell = OrderPanels::Cell;
using SmoothRun = OrderPanels::SmoothRun;
using CellTerms = decltype(Cell::series);

constexpr int kMinOrderNodes = 6;  // Chebyshev nodes and terms in ln m
constexpr int kMaxOrderNodes = 24;
// Distances of singularities from the real axis of ln m.
constexpr double kNearestPole = 0.5 * std::numbers::pi;   // poles and branch cuts of a modulus
constexpr double kNearestBend = 0.25 * std::numbers::pi;  // limited frequencies of measured moduli

constexpr double kLargestOrderRatio = 8.0;  // ratio of m over a cell, over which a relaxation is resolved
// A bound of cells in m. Cells between fixed bounds serve all meshes. From this order on, the orders of a body around a
// center are as close together as in the first band of all orders.
constexpr double kBoundOfCells = 4.0;
constexpr double kSmallestRatio = 1.05;  // the remainder of a cell this narrow is round-off

auto k_transform() { return panel_transform().cast<cplx>(); }

/// Number of Chebyshev terms in ln m of a function on a range, at a distance from its poles and branch cuts. The terms
/// fall like powers of the sum of the semi-axes of the ellipse around the range that passes through the nearest
/// singularity.
int order_terms(double lowest_m, double highest_m, double distance) {
  const double reach = 2.0 * distance / std::log(highest_m / lowest_m);  // per half the range
  const double terms = -std::log(kSeriesTolerance) / std::asinh(reach);
  return std::clamp(static_cast<int>(std::ceil(terms)) + 1, kMinOrderNodes, kMaxOrderNodes);
}

/// Compliance at the nodes of a cell, multiplied by m and the modulus of the outer layer. Entries that are odd in n are
/// divided by n / m.
///
/// The nodes are solved in three groups, so that few solutions show whether a cell must be halved: all k at the
/// outermost m, which show the convergence of the series in k; all m at the outermost k, which show that of the series
/// in m; and the rest.
class CellSamples {
 public:
  CellSamples(const HarmonicBody& body, const SmoothRun& run, const Cell& cell)
      : m_(chebyshev_nodes(cell.lowest_m, cell.highest_m, run.nodes)),
        m_count_(run.nodes),
        m_transform_(chebyshev_transform(m_count_).transpose().cast<cplx>()),
        ratios_(panel_nodes(cell.lowest_ratio, cell.highest_ratio)),
        highest_n_ratio_(std::sqrt(cell.highest_ratio - 1.0)),
        body_(body.resampled(m_, run.measured.at(m_))),
        values_(m_count_, kEntries * kPanelNodes) {}

  /// Solve all k at the outermost m.
  /// @return whether the last terms along k are negligible there
  [[nodiscard]] bool is_resolved_along_k() {
    solve({0, m_count_ - 1}, inner_nodes(kPanelNodes, 0));
    return is_resolved([&](int entry) { return (rows(entry) * k_transform()).eval(); }, kLastColumns);
  }

  /// Solve all m at the outermost k.
  /// @return whether the last terms along m are negligible there
  [[nodiscard]] bool is_resolved_along_m() {
    solve(inner_nodes(m_count_, 1), {0, kPanelNodes - 1});
    return is_resolved([&](int entry) { return (m_transform_ * columns(entry)).eval(); }, kLastRows);
  }

  /// Solve the remaining nodes and compute the series in both directions.
  void complete() {
    solve(inner_nodes(m_count_, 1), inner_nodes(kPanelNodes, 1));
    for (int entry = 0; entry < kEntries; ++entry) {
      auto block = values_.middleCols<kPanelNodes>(Eigen::Index{entry} * kPanelNodes);
      block = (m_transform_ * block * k_transform()).eval();
    }
  }

  /// Whether the last terms along k, or along m, are negligible in the whole series. The function may vary between the
  /// outermost orders.
  [[nodiscard]] bool is_complete_along_k() const {
    return is_resolved([this](int entry) { return block(entry); }, kLastColumns);
  }
  [[nodiscard]] bool is_complete_along_m() const {
    return is_resolved([this](int entry) { return block(entry); }, kLastRows);
  }

  [[nodiscard]] CellTerms take_terms() { return std::move(values_); }

 private:
  static std::vector<int> inner_nodes(int count, int margin) {
    std::vector<int> nodes(static_cast<std::size_t>(count - 2 * margin));
    std::iota(nodes.begin(), nodes.end(), margin);
    return nodes;
  }

  static constexpr auto kLastColumns = [](const auto& series) { return series.template rightCols<2>(); };
  static constexpr auto kLastRows = [](const auto& series) { return series.template bottomRows<2>(); };

  [[nodiscard]] Eigen::Matrix<cplx, Eigen::Dynamic, kPanelNodes> block(int entry) const {
    return values_.middleCols<kPanelNodes>(Eigen::Index{entry} * kPanelNodes);
  }
  /// Values of an entry at the outermost m.
  [[nodiscard]] Eigen::Matrix<cplx, 2, kPanelNodes> rows(int entry) const {
    return values_(std::array{0, m_count_ - 1}, Eigen::seqN(entry * kPanelNodes, kPanelNodes));
  }
  /// Values of an entry at the outermost k.
  [[nodiscard]] Eigen::Matrix<cplx, Eigen::Dynamic, 2> columns(int entry) const {
    return values_(Eigen::all, std::array{entry * kPanelNodes, (entry + 1) * kPanelNodes - 1});
  }

  /// Whether the last terms of every entry's series are negligible.
  template <class SeriesOf, class LastTerms>
  [[nodiscard]] bool is_resolved(const SeriesOf& series_of, const LastTerms& last_terms) const {
    const auto largest = [&](Entry entry) { return series_of(static_cast<int>(entry)).cwiseAbs().maxCoeff(); };
    const auto sizes = entry_sizes(largest(Entry::rr), largest(Entry::phiphi), 1.0, highest_n_ratio_);
    const double tolerance = series_tolerance(body_);
    for (int entry = 0; entry < kEntries; ++entry) {
      const double last = last_terms(series_of(entry)).cwiseAbs().maxCoeff();
      if (last > tolerance * sizes[static_cast<std::size_t>(entry)]) return false;
    }
    return true;
  }

  void solve(const std::vector<int>& m_nodes, const std::vector<int>& k_nodes) {
    // Orders with the same k^2 / m^2 are adjacent.
    std::vector<IndexedOrder> orders;
    for (const int j : k_nodes) {
      for (const int i : m_nodes) {
        const auto place = static_cast<std::size_t>(i);
        orders.push_back({.i = place, .n = m_[place] * std::sqrt(ratios_[static_cast<std::size_t>(j)] - 1.0)});
      }
    }
    std::vector<Eigen::Matrix3cd> solved(orders.size());
    body_.compliances(orders, solved);
    auto order = orders.begin();
    auto compliance = solved.begin();
    for (const int j : k_nodes) {
      for (const int i : m_nodes) {
        const double m = m_[order->i];
        const Eigen::Matrix3cd y = *compliance++ * (m * body_.outer_modulus(order->i));
        const double n_ratio = order->n / m;
        ++order;
        const std::array<cplx, kEntries> entries{y(0, 0), y(0, 1),           y(0, 2) / n_ratio,
                                                 y(1, 1), y(1, 2) / n_ratio, y(2, 2)};
        for (int e = 0; e < kEntries; ++e) values_(i, e * kPanelNodes + j) = entries[static_cast<std::size_t>(e)];
      }
    }
  }

  std::vector<double> m_;
  int m_count_;
  Eigen::MatrixXcd m_transform_;
  std::array<double, kPanelNodes> ratios_;  // k^2 / m^2
  double highest_n_ratio_;
  HarmonicBody body_;  // at the nodes m_
  CellTerms values_;
};

/// Append cells that resolve the compliance on the range of `cell`, which is halved until they do.
void append_cells(const HarmonicBody& body, const SmoothRun& run, Cell cell, const Worker& worker,
                  std::vector<Cell>& cells) {
  worker.checkpoint();
  const bool is_wide_along_k = cell.highest_ratio / cell.lowest_ratio > kSmallestRatio;
  const bool is_wide_along_m = cell.highest_m / cell.lowest_m > kSmallestRatio;
  const auto append = [&](double lowest_m, double highest_m, double lowest_ratio, double highest_ratio) {
    append_cells(body, run, {lowest_m, highest_m, lowest_ratio, highest_ratio, {}}, worker, cells);
  };
  const auto halve_along_k = [&] {
    const double middle = std::sqrt(cell.lowest_ratio * cell.highest_ratio);
    append(cell.lowest_m, cell.highest_m, cell.lowest_ratio, middle);
    append(cell.lowest_m, cell.highest_m, middle, cell.highest_ratio);
  };
  const auto halve_along_m = [&] {
    const double middle = std::sqrt(cell.lowest_m * cell.highest_m);
    append(cell.lowest_m, middle, cell.lowest_ratio, cell.highest_ratio);
    append(middle, cell.highest_m, cell.lowest_ratio, cell.highest_ratio);
  };
  CellSamples samples(body, run, cell);
  if (!samples.is_resolved_along_k() && is_wide_along_k) return halve_along_k();
  if (!samples.is_resolved_along_m() && is_wide_along_m) return halve_along_m();
  samples.complete();
  if (!samples.is_complete_along_k() && is_wide_along_k) return halve_along_k();
  if (!samples.is_complete_along_m() && is_wide_along_m) return halve_along_m();
  cell.series = samples.take_terms();
  cells.push_back(std::move(cell));
}

using CellCache = RecentCache<std::vector<Cell>>;

/// Cells of the bodies that were solved last, for further loads and meshes, and for further speeds if the layers share
/// one relaxation function and have no inertia.
CellCache& recent_cells() {
  constexpr std::size_t kMaxParts = 256;         // some ten for each body
  constexpr std::size_t kMaxNumbers = 16777216;  // complex: 256 MB
  static CellCache cache(kMaxParts, kMaxNumbers);
  return cache;
}

std::size_t numbers_in(const std::vector<Cell>& cells) {
  Eigen::Index sum = 0;
  for (const Cell& cell : cells) sum += cell.series.size();
  return static_cast<std::size_t>(sum);
}

/// All numbers that determine the cells of a part: its bounds, the body, and the layers in units of the outer modulus.
/// The series in ln m represent the moduli, so that their values at the nodes in ln m suffice.
CellCache::Key properties(const HarmonicBody& body, const SmoothRun& run, const Cell& part) {
  const std::vector<double> m = chebyshev_nodes(part.lowest_m, part.highest_m, run.nodes);
  const HarmonicBody sampled = body.resampled(m, run.measured.at(m));
  const Crown& crown = body.body().crown;
  CellCache::Key key{std::log(part.lowest_m), std::log(part.highest_m),     part.lowest_ratio,
                     part.highest_ratio,      crown.radius / body.radius(), crown.proportion};
  for (std::size_t i = 0; i < m.size(); ++i) append_numbers(sampled.layers_at(i), sampled.outer_modulus(i), key);
  return key;
}

/// Values of T_0, T_1, ... at the coordinate of m in a cell.
Eigen::RowVectorXd chebyshev_polynomials(const Cell& cell, double m) {
  const double x = 2.0 * std::log(m / cell.lowest_m) / std::log(cell.highest_m / cell.lowest_m) - 1.0;
  Eigen::RowVectorXd values(cell.series.rows());
  values[0] = 1.0;
  values[1] = x;
  for (Eigen::Index i = 2; i < values.size(); ++i) values[i] = 2.0 * x * values[i - 1] - values[i - 2];
  return values;
}

/// Longest smooth run at the beginning of a list of orders. Without measured moduli its bounds do not depend on the
/// orders.
/// @param[in] orders indices of the orders, ascending in m
SmoothRun first_smooth_run(const HarmonicBody& body, std::span<const std::size_t> orders) {
  const auto order = [&](std::size_t i) { return body.orders()[i]; };
  const double front = order(orders.front());
  if (measured_layers(body.body().layers).empty()) {
    const double bound = std::floor(std::log(front / kBoundOfCells) / std::log(kLargestOrderRatio));
    const double lowest_m = kBoundOfCells * std::pow(kLargestOrderRatio, bound);
    const double highest_m = kLargestOrderRatio * lowest_m;
    const auto end = std::ranges::upper_bound(orders, highest_m, {}, order);
    return {.lowest_m = lowest_m,
            .highest_m = highest_m,
            .count = static_cast<std::size_t>(end - orders.begin()),
            .measured = {},
            .nodes = kMaxOrderNodes};
  }
  const auto end = std::ranges::upper_bound(orders, kLargestOrderRatio * front, {}, order);
  const auto most = static_cast<std::size_t>(end - orders.begin());
  SmoothRun run;
  const auto extend_to = [&](std::size_t count) {
    const double highest = order(orders[count - 1]);
    auto measured = MeasuredModuli::try_make(body, orders.first(count), order_terms(front, highest, kNearestPole));
    if (!measured) return false;
    const int nodes = order_terms(front, highest, kNearestBend);
    run = {.lowest_m = front, .highest_m = highest, .count = count, .measured = std::move(*measured), .nodes = nodes};
    return true;
  };
  extend_to(1);
  // Double the length until the run contains a kink, then bisect to the kink.
  std::size_t beyond = most + 1;
  while (run.count < most) {
    const std::size_t longer = std::min(2 * run.count, most);
    if (extend_to(longer)) continue;
    beyond = longer;
    break;
  }
  while (run.count + 1 < beyond) {
    const std::size_t middle = run.count + (beyond - run.count) / 2;
    if (!extend_to(middle)) beyond = middle;
  }
  return run;
}

}  // namespace

std::optional<MeasuredModuli> MeasuredModuli::try_make(const HarmonicBody& body, std::span<const std::size_t> orders,
                                                       int max_terms) {
  const std::vector<std::size_t> layers = measured_layers(body.body().layers);
  const auto count = static_cast<Eigen::Index>(orders.size());
  MeasuredModuli moduli;
  moduli.lowest_m_ = body.orders()[orders.front()];
  moduli.highest_m_ = body.orders()[orders.back()];
  moduli.layers_ = static_cast<Eigen::Index>(layers.size());

  Eigen::ArrayXd points(count);
  Eigen::ArrayXXcd rest(count, moduli.layers_);  // moduli minus polynomials
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t order = orders[static_cast<std::size_t>(i)];
    points[i] = moduli.coordinate(body.orders()[order]);
    for (Eigen::Index l = 0; l < moduli.layers_; ++l) {
      rest(i, l) = body.modulus(layers[static_cast<std::size_t>(l)], order);
    }
  }
  const Eigen::ArrayXXd limit = kModulusTolerance * rest.abs();
  Eigen::ArrayXd product = Eigen::ArrayXd::Ones(count);  // product of twice the distances to the nodes
  while (!(rest.abs() <= limit).all()) {
    Eigen::Index node = 0;
    if (std::cmp_equal(moduli.nodes_.size(), max_terms) || product.abs().maxCoeff(&node) == 0.0) return {};
    moduli.nodes_.push_back(points[node]);
    moduli.coefficients_.emplace_back(rest.row(node).transpose() / product[node]);
    rest -= (product.matrix().cast<std::complex<double>>() * moduli.coefficients_.back().matrix().transpose()).array();
    product *= 2.0 * (points - points[node]);
  }
  return moduli;
}

Eigen::ArrayXXcd MeasuredModuli::at(std::span<const double> orders) const {
  Eigen::ArrayXXcd moduli(static_cast<Eigen::Index>(orders.size()), layers_);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const double x = coordinate(orders[i]);
    Eigen::ArrayXcd sum = Eigen::ArrayXcd::Zero(layers_);
    for (std::size_t j = nodes_.size(); j-- > 0;) sum = coefficients_[j] + 2.0 * (x - nodes_[j]) * sum;
    moduli.row(static_cast<Eigen::Index>(i)) = sum.transpose();
  }
  return moduli;
}

double MeasuredModuli::coordinate(double m) const {
  if (highest_m_ == lowest_m_) return 0.0;
  return 2.0 * std::log(m / lowest_m_) / std::log(highest_m_ / lowest_m_) - 1.0;
}

void OrderByOrderSpectrum::series(std::size_t i, OrderSeries& series) const {
  // The nodes and bounds of the panels are values of k^2 = m^2 + n^2.
  const double m = body_->orders()[i];
  const auto sample = [&](const std::array<double, kPanelNodes>& nodes) {
    std::array<IndexedOrder, kPanelNodes> orders{};
    std::array<Eigen::Matrix3cd, kPanelNodes> compliances;
    for (std::size_t j = 0; j < orders.size(); ++j) orders[j] = {.i = i, .n = std::sqrt(nodes[j] - m * m)};
    body_->compliances(orders, compliances);
    Eigen::Matrix<cplx, kEntries, kPanelNodes> entries;
    for (std::size_t j = 0; j < orders.size(); ++j) {
      const Eigen::Matrix3cd& y = compliances[j];
      const double n = orders[j].n;
      entries.col(static_cast<Eigen::Index>(j)) << y(0, 0), y(0, 1), y(0, 2) / n, y(1, 1), y(1, 2) / n, y(2, 2);
    }
    return entries;
  };
  series.clear();
  double lowest = m * m;
  if (m == 0.0) {
    // Constant up to the end of order (0, 0), in which the entries between different directions are 0.
    const IndexedOrder zero{.i = i, .n = 0.0};
    Eigen::Matrix3cd y;
    body_->compliances(std::span(&zero, 1), std::span(&y, 1));
    Eigen::VectorXcd entries(kEntries);
    entries << y(0, 0), 0.0, 0.0, y(1, 1), 0.0, y(2, 2);
    lowest = end_of_zero_order(body_->metric());
    append_constants(lowest, entries, series);
  }
  const double highest = m * m + highest_n_ * highest_n_;
  const double tolerance = series_tolerance(*body_);
  const auto append = [&](double low, double high) {
    append_panels(
        low, high, sample, [m, tolerance](const Panel<cplx>& panel) { return is_resolved(panel, m, tolerance); },
        series);
  };
  if (lowest < kLowOrders && kLowOrders < highest) {
    append(lowest, kLowOrders);
    lowest = kLowOrders;
  }
  append(lowest, highest);
}

OrderPanels::OrderPanels(std::shared_ptr<const HarmonicBody> body, double highest_n, int threads, Watch& watch)
    : body_(std::move(body)), highest_n_(highest_n), one_by_one_(body_, highest_n) {
  find_ranges();
  struct Part {
    const SmoothRun* run;
    Cell cell;
    std::shared_ptr<const std::vector<Cell>>* solved;
  };
  std::vector<Part> parts;
  for (auto& [run, solved] : ranges_) {
    const double highest = 1.0 + std::pow(highest_n / run.lowest_m, 2);
    const int count = static_cast<int>(std::ceil(std::log(highest) / std::log(kLargestPanelRatio)));
    solved.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      parts.push_back({.run = &run,
                       .cell = {.lowest_m = run.lowest_m,
                                .highest_m = run.highest_m,
                                .lowest_ratio = std::pow(kLargestPanelRatio, i),
                                .highest_ratio = std::pow(kLargestPanelRatio, i + 1),
                                .series = {}},
                       .solved = &solved[static_cast<std::size_t>(i)]});
    }
  }
  parallel_for(parts.size(), threads, watch, "solving layers", [&](std::size_t p, const Worker& worker) {
    const auto& [run, cell, solved] = parts[p];
    CellCache::Key key = properties(*body_, *run, cell);
    *solved = recent_cells().find(key);
    if (*solved) return;
    std::vector<Cell> cells;
    append_cells(*body_, *run, cell, worker, cells);
    const std::size_t size = numbers_in(cells);
    *solved = std::make_shared<const std::vector<Cell>>(std::move(cells));
    recent_cells().add(std::move(key), *solved, size);
  });
}

void OrderPanels::find_ranges() {
  const double lowest_m = body_->metric().is_curved() ? 2.0 : 0.0;  // below, the few integer orders do not need panels
  const std::vector<double>& m = body_->orders();
  std::vector<std::size_t> ascending(m.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  std::ranges::sort(ascending, {}, [&](std::size_t i) { return m[i]; });
  const auto lowest = std::ranges::lower_bound(ascending, lowest_m, {}, [&](std::size_t i) { return m[i]; });
  for (std::span<const std::size_t> left(lowest, ascending.end()); !left.empty();) {
    SmoothRun run = first_smooth_run(*body_, left);
    if (std::cmp_greater(run.count, run.nodes)) {
      left = left.subspan(run.count);
      ranges_.push_back({.run = std::move(run), .parts = {}});
    } else {
      left = left.subspan(1);
    }
  }
}

const OrderPanels::Range* OrderPanels::range_of(double m) const {
  const auto range = std::ranges::find_if(ranges_, [m](const Range& r) { return m <= r.run.highest_m; });
  return range != ranges_.end() && m >= range->run.lowest_m ? &*range : nullptr;
}

void OrderPanels::series(std::size_t i, OrderSeries& series) const {
  const double m = body_->orders()[i];
  const Range* range = range_of(m);
  if (!range) return one_by_one_.series(i, series);

  const cplx unit = 1.0 / (m * body_->outer_modulus(i));
  std::size_t used = 0;
  for (const auto& part : range->parts) {
    for (const Cell& cell : *part) {
      const bool is_last = cell.highest_m == range->run.highest_m;
      if (m < cell.lowest_m || (m >= cell.highest_m && !is_last)) continue;
      if (m * m * (cell.lowest_ratio - 1.0) > highest_n_ * highest_n_) continue;
      if (used == series.size()) series.emplace_back();
      auto& panel = series[used++];
      panel.low = m * m * cell.lowest_ratio;
      panel.high = m * m * cell.highest_ratio;
      const Eigen::Matrix<cplx, 1, kEntries * kPanelNodes> terms = chebyshev_polynomials(cell, m) * cell.series;
      panel.series.resize(kEntries, kPanelNodes);
      for (int entry = 0; entry < kEntries; ++entry) {
        const cplx factor = is_odd(static_cast<Entry>(entry)) ? unit / m : unit;
        panel.series.row(entry) = factor * terms.segment<kPanelNodes>(Eigen::Index{entry} * kPanelNodes);
      }
    }
  }
  series.resize(used);
}

}  // namespace viscoroll::detail
