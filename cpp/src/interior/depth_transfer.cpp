#include "interior/depth_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/dense_products.hpp"
#include "modal/lanes.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t kStates = 6;

/// Largest ratio of k^2 at the ends of a panel. Wider panels rarely resolve exp(-k depth), so their samples are wasted.
constexpr double kPanelRatio = 8.0;

/// All entries under the loaded components. With k along theta, phi is not coupled to theta and r.
std::vector<DepthSeries::Entry> entries_of(const LoadedComponents& loaded, bool along_theta) {
  const bool tangential = loaded[1] || loaded[2];
  std::vector<DepthSeries::Entry> entries;
  for (std::size_t component = 0; component < kStates; ++component) {
    for (std::size_t column = 0; column < loaded.size(); ++column) {
      const bool apart = along_theta && (component % 3 == 1) != (column == 1);
      const bool wanted = along_theta && column > 0 ? tangential : loaded[column];
      if (wanted && !apart) entries.push_back({component, column});
    }
  }
  return entries;
}

using Orders = std::span<const OrderInLayers<cplx>>;

/// Whether an order is the mean of a flat surface.
bool is_uniform(const OrderInLayers<cplx>& order) {
  return order.m == 0.0 && order.n == 0.0 && !order.layers.metric.is_curved();
}

/// States of flat layers under uniform stresses, which every depth carries. The displacement is relative to a rigid
/// base, or else to the surface, since that of a half-space is infinite.
std::vector<DepthState> uniform_states(const LayerStack<cplx>& layers) {
  std::vector<DepthState> states(layers.media.size() + 1, DepthState::Zero());
  for (DepthState& state : states) state.bottomRows<3>().setIdentity();
  const bool is_held = !layers.media.front().is_half_space();
  for (std::size_t piece = 0; piece < layers.media.size(); ++piece) {
    const Medium<cplx>& medium = layers.media[piece];
    if (medium.is_half_space()) continue;
    // Normal strain b / mu and shear strain 1 / mu per stress, on states whose stresses are multiplied by a length.
    const cplx stretch = (medium.outer - medium.inner) / (medium.mu * layers.metric.length(medium.outer));
    states[piece + 1].topRows<3>() = states[piece].topRows<3>();
    states[piece + 1](0, 0) += medium.b * stretch;
    for (const int along : {1, 2}) states[piece + 1](along, along) += stretch;
  }
  if (is_held) return states;
  const Eigen::Matrix3cd surface = states.back().topRows<3>();
  for (DepthState& state : states) state.topRows<3>() -= surface;
  return states;
}

/// Entries of the states at boundaries, one column per order; only the first order may be uniform.
Eigen::Matrix<cplx, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> solved(
    Orders orders, const std::vector<std::size_t>& boundaries, const std::vector<DepthSeries::Entry>& entries) {
  std::vector<std::vector<DepthState>> states(orders.size());
  const std::size_t uniform = is_uniform(orders.front()) ? 1 : 0;
  if (uniform > 0) states.front() = uniform_states(orders.front().layers);
  depth_states(orders.subspan(uniform), std::span(states).subspan(uniform));
  Eigen::Matrix<cplx, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values(
      static_cast<Index>(boundaries.size() * entries.size()), static_cast<Index>(orders.size()));
  for (std::size_t i = 0; i < orders.size(); ++i) {
    Index row = 0;
    for (const std::size_t boundary : boundaries) {
      for (const DepthSeries::Entry& entry : entries) {
        const cplx value = states[i][boundary](static_cast<Index>(entry.component), static_cast<Index>(entry.column));
        const double divisor = entry.is_odd() && orders[i].n > 0.0 ? orders[i].n : 1.0;
        values(row++, static_cast<Index>(i)) = value / divisor;
      }
    }
  }
  return values;
}

}  // namespace

DepthSeries::DepthSeries(LayerStack<cplx> pieces, std::vector<std::size_t> boundaries, double m, Range n,
                         std::vector<Entry> entries, double tolerance)
    : pieces_(std::move(pieces)),
      boundaries_(std::move(boundaries)),
      m_(m),
      entries_(std::move(entries)),
      tolerance_(tolerance) {
  double lowest = m * m + n.lowest * n.lowest;
  const bool one = n.highest == 0.0;
  if (one || lowest == 0.0) {
    const std::array square{lowest};
    lowest = std::max(lowest, end_of_zero_order(pieces_.metric));
    append_constants<cplx>(lowest, solve(square).col(0), panels_);
  }
  const double highest = one ? lowest : m * m + std::max(n.highest * n.highest, 1.0);
  if (lowest < kLowOrders && kLowOrders < highest) {
    append(lowest, kLowOrders);
    lowest = kLowOrders;
  }
  if (lowest < highest) append(lowest, highest);
  is_real_ = std::ranges::all_of(panels_, [](const Panel<cplx>& panel) { return panel.series.imag().isZero(0.0); });
}

DepthSeries::DepthSeries(double m, const Eigen::VectorXcd& constants, std::vector<Entry> entries)
    : m_(m), entries_(std::move(entries)), tolerance_(0.0), is_real_(constants.imag().isZero(0.0)) {
  append_constants<cplx>(m * m, constants, panels_);
}

std::vector<std::shared_ptr<const DepthSeries>> DepthSeries::under_line(Orders orders,
                                                                        const std::vector<std::size_t>& boundaries,
                                                                        const std::vector<Entry>& entries) {
  const Values values = solved(orders, boundaries, entries);
  std::vector<std::shared_ptr<const DepthSeries>> series;
  series.reserve(orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    series.emplace_back(new DepthSeries(orders[i].m, values.col(static_cast<Index>(i)), entries));
  }
  return series;
}

void DepthSeries::append(double low, double high) {
  if (high / low > kPanelRatio) {
    const double middle = std::max(high / kPanelRatio, std::sqrt(low * high));
    append(low, middle);
    append(middle, high);
    return;
  }
  append_panels(
      low, high, [this](const std::array<double, kPanelNodes>& nodes) { return solve(nodes); },
      [this](const Panel<cplx>& panel) { return is_resolved(panel); }, panels_);
}

DepthSeries::Values DepthSeries::solve(std::span<const double> squares) const {
  std::vector<OrderInLayers<cplx>> orders;
  for (const double square : squares) {
    orders.push_back({.layers = pieces_, .m = m_, .n = std::sqrt(std::max(square - m_ * m_, 0.0))});
  }
  return solved(orders, boundaries_, entries_);
}

bool DepthSeries::is_resolved(const Panel<cplx>& panel) const {
  const double highest_n = std::sqrt(std::max(panel.high - m_ * m_, 1.0));
  const auto for_rows = [&](const auto& function) {
    Index row = 0;
    for (std::size_t boundary = 0; boundary < boundaries_.size(); ++boundary) {
      for (const Entry& entry : entries_) function(row++, entry.component < 3, entry.is_odd() ? highest_n : 1.0);
    }
  };
  // Stresses are compared with their load, displacements with the largest displacement.
  double displacement = 0.0;
  for_rows([&](Index row, bool displaced, double scale) {
    if (displaced) displacement = std::max(displacement, scale * panel.series.row(row).cwiseAbs().maxCoeff());
  });
  bool resolved = true;
  for_rows([&](Index row, bool displaced, double scale) {
    const double last = scale * panel.series.row(row).template tail<2>().cwiseAbs().maxCoeff();
    resolved = resolved && last <= tolerance_ * (displaced ? displacement : 1.0);
  });
  return resolved;
}

DepthTransfer::DepthTransfer(std::shared_ptr<const DepthSeries> series, double m, const Eigen::ArrayXd& n,
                             cplx modulus_ratio)
    : series_(std::move(series)), modulus_ratio_(modulus_ratio) {
  const Eigen::ArrayXd squares = m * m + n.square();
  if (is_shared()) {
    const Eigen::ArrayXd k = squares.sqrt();
    odd_factor_ = k.cast<cplx>();
    cosine_.resize(k.size());
    sine_.resize(k.size());
    for (Index i = 0; i < k.size(); ++i) {
      cosine_[i] = k[i] > 0.0 ? m / k[i] : 0.0;
      sine_[i] = k[i] > 0.0 ? n[i] / k[i] : 1.0;
    }
  } else {
    odd_factor_ = n.cast<cplx>();
  }
  Index first = 0;
  for (const Panel<cplx>& panel : series_->panels()) {
    const double* end = std::upper_bound(squares.data() + first, squares.data() + squares.size(), panel.high);
    const Index last = &panel == &series_->panels().back() ? squares.size() : end - squares.data();
    const Index count = last - first;
    first_.push_back(first);
    Eigen::MatrixXd& chebyshev = chebyshev_.emplace_back(Eigen::MatrixXd::Zero(kPanelNodes, count));
    first = last;
    if (count == 0) continue;
    chebyshev.row(0).setOnes();
    if (panel.low == 0.0) continue;
    const double scale = 2.0 / std::log(panel.high / panel.low);
    const Eigen::ArrayXd x = (squares.segment(last - count, count) / panel.low).log() * scale - 1.0;
    for (Index i = 0; i < count; ++i) {
      chebyshev(1, i) = x[i];
      for (int j = 2; j < kPanelNodes; ++j) {
        chebyshev(j, i) = 2.0 * x[i] * chebyshev(j - 1, i) - chebyshev(j - 2, i);
      }
    }
  }
  first_.push_back(first);
}

ComponentRows DepthTransfer::values(std::size_t boundary, Index count) const {
  const auto rows = static_cast<Index>(series_->entries().size());
  ComponentRows values = ComponentRows::Zero(rows, count);
  for (std::size_t p = 0; p < series_->panels().size() && first_[p] < count; ++p) {
    const Index width = std::min(first_[p + 1], count) - first_[p];
    if (width == 0) continue;
    const auto series = series_->panels()[p].series.middleRows(static_cast<Index>(boundary) * rows, rows);
    if (series_->panels()[p].low == 0.0) {
      values.middleCols(first_[p], width).colwise() = series.col(0).array();
      continue;
    }
    const auto chebyshev = chebyshev_[p].leftCols(width);
    const RowMajor real = series.real();
    values.middleCols(first_[p], width).real() = product(real, chebyshev);
    if (series_->is_real()) continue;
    const RowMajor imaginary = series.imag();
    values.middleCols(first_[p], width).imag() = product(imaginary, chebyshev);
  }
  return values;
}

void DepthTransfer::state(std::size_t boundary, Index count, const LoadRows& loads, ComponentRows& state) const {
  const ComponentRows values = this->values(boundary, count);
  LoadRows turned = loads.leftCols(count);
  const auto cosine = cosine_.head(is_shared() ? count : 0);
  const auto sine = sine_.head(is_shared() ? count : 0);
  if (is_shared()) {
    // In the frame with k along theta, theta is along k, and phi is opposite to the direction across k.
    turned.row(1) = sine * loads.row(1).head(count) - cosine * loads.row(2).head(count);
    turned.row(2) = cosine * loads.row(1).head(count) + sine * loads.row(2).head(count);
  }
  state.setZero(kStates, count);
  for (std::size_t row = 0; row < series_->entries().size(); ++row) {
    const DepthSeries::Entry& entry = series_->entries()[row];
    auto sum = state.row(static_cast<Index>(entry.component));
    const auto share = values.row(static_cast<Index>(row)) * turned.row(static_cast<Index>(entry.column));
    if (entry.is_odd()) {
      sum += odd_factor_.head(count) * share;
    } else {
      sum += share;
    }
  }
  if (!is_shared()) return;
  for (const Index phi : {1, 4}) {
    const Eigen::Array<cplx, 1, Eigen::Dynamic> across = state.row(phi);
    const Eigen::Array<cplx, 1, Eigen::Dynamic> along = state.row(phi + 1);
    state.row(phi) = sine * across + cosine * along;
    state.row(phi + 1) = sine * along - cosine * across;
  }
  state.topRows(3) /= modulus_ratio_;
}

DepthTransfers::DepthTransfers(const HarmonicBody& body, const LayerCuts& cuts, std::vector<std::size_t> boundaries,
                               double highest_k, const LoadedComponents& loaded, const Accuracy& accuracy)
    : body_(body), cuts_(cuts), boundaries_(std::move(boundaries)), tolerance_(accuracy.tolerance) {
  const bool shares = can_share(accuracy.inertia);
  entries_ = entries_of(loaded, shares);
  if (!shares) return;
  auto pieces = cuts_.pieces(body_.layers_at(0));
  for (auto& piece : pieces.media) piece.inertia = 0.0;
  const DepthSeries::Range k{.lowest = body_.metric().is_curved() ? 0.0 : body_.orders().front(), .highest = highest_k};
  shared_ = std::make_shared<const DepthSeries>(std::move(pieces), boundaries_, 0.0, k, entries_, tolerance_);
}

bool DepthTransfers::can_share(double negligible_inertia) const {
  constexpr double kSame = 1e-12;
  if (body_.metric().along != body_.metric().across) return false;
  const std::vector<Layer>& layers = body_.body().layers;
  const double speed = body_.angular_speed() * body_.radius();
  for (std::size_t l = 0; l < layers.size(); ++l) {
    if (!layers[l].poisson_ratio ||
        layers[l].density * speed * speed > negligible_inertia * body_.modulus(l, 0).real()) {
      return false;
    }
    const cplx ratio = body_.modulus(l, 0) / body_.modulus(0, 0);
    for (std::size_t i = 0; i < body_.orders().size(); ++i) {
      if (std::abs(body_.modulus(l, i) / body_.modulus(0, i) - ratio) > kSame * std::abs(ratio)) return false;
    }
  }
  return true;
}

std::size_t DepthTransfers::at_once() const { return is_line() ? kLanes : 1; }

std::vector<DepthTransfer> DepthTransfers::at(std::size_t first, std::size_t count, const Eigen::ArrayXd& n) const {
  std::vector<DepthTransfer> transfers;
  if (is_line()) {
    std::vector<LayerStack<cplx>> pieces;
    std::vector<OrderInLayers<cplx>> orders;
    pieces.reserve(count);
    for (std::size_t i = first; i < first + count; ++i) {
      pieces.push_back(cuts_.pieces(body_.layers_at(i)));
      orders.push_back({.layers = pieces.back(), .m = body_.orders()[i], .n = 0.0});
    }
    for (auto& series : DepthSeries::under_line(orders, boundaries_, entries_)) {
      const double m = orders[transfers.size()].m;
      transfers.emplace_back(std::move(series), m, n, 0.0);
    }
    return transfers;
  }
  const DepthSeries::Range range{.lowest = 0.0, .highest = n[n.size() - 1]};
  for (std::size_t i = first; i < first + count; ++i) {
    const double m = body_.orders()[i];
    if (shared_) {
      transfers.emplace_back(shared_, m, n, body_.modulus(0, i) / body_.modulus(0, 0));
    } else {
      transfers.emplace_back(std::make_shared<const DepthSeries>(cuts_.pieces(body_.layers_at(i)), boundaries_, m,
                                                                 range, entries_, tolerance_),
                             m, n, 0.0);
    }
  }
  return transfers;
}

}  // namespace viscoroll::detail
