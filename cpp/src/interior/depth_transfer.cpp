#include "interior/depth_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modal/compliance_recursion.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr std::size_t kStates = 6;

/// Of k^2 at the ends of a panel: wider ones hold exp(-k depth) only rarely, and would be sampled in vain.
constexpr double kPanelRatio = 8.0;

/// Whether an entry changes sign with n: one of its two directions is theta.
bool is_odd(std::size_t component, std::size_t column) { return (component % 3 == 2) != (column == 2); }

}  // namespace

DepthTransfer::DepthTransfer(std::span<const Medium<cplx>> layers, const LayerCuts& cuts,
                             std::vector<std::size_t> boundaries, double m, double highest_n,
                             const LoadedComponents& loaded, double tolerance)
    : boundaries_(std::move(boundaries)), m_(m), tolerance_(tolerance) {
  for (std::size_t column = 0; column < loaded.size(); ++column) {
    if (loaded[column]) columns_.push_back(column);
  }
  const auto pieces = cuts.pieces(layers);
  double lowest = m * m;
  if (m == 0.0) {
    const std::array zero{0.0};
    append_constants<cplx>(kZeroOrder, solve(pieces, zero).col(0), panels_);
    lowest = kZeroOrder;
  }
  const double highest = m * m + std::max(highest_n * highest_n, 1.0);
  if (lowest < kLowOrders && kLowOrders < highest) {
    append(pieces, lowest, kLowOrders);
    lowest = kLowOrders;
  }
  append(pieces, lowest, highest);
}

void DepthTransfer::append(const std::vector<Medium<cplx>>& pieces, double low, double high) {
  if (high / low > kPanelRatio) {
    const double middle = std::max(high / kPanelRatio, std::sqrt(low * high));
    append(pieces, low, middle);
    append(pieces, middle, high);
    return;
  }
  append_panels(
      low, high, [&](const std::array<double, kPanelNodes>& nodes) { return solve(pieces, nodes); },
      [this](const Panel<cplx>& panel) { return is_resolved(panel); }, panels_);
}

DepthTransfer::Entries DepthTransfer::solve(const std::vector<Medium<cplx>>& pieces,
                                            std::span<const double> squares) const {
  std::vector<OrderInLayers<cplx>> orders;
  for (const double square : squares) {
    orders.push_back({.media = pieces, .m = m_, .n = std::sqrt(std::max(square - m_ * m_, 0.0))});
  }
  std::vector<std::vector<DepthState>> states(orders.size());
  depth_states(orders, states);
  Entries entries(static_cast<Eigen::Index>(boundaries_.size() * kStates * columns_.size()),
                  static_cast<Eigen::Index>(orders.size()));
  for (std::size_t i = 0; i < orders.size(); ++i) {
    Eigen::Index row = 0;
    for (const std::size_t boundary : boundaries_) {
      for (std::size_t component = 0; component < kStates; ++component) {
        for (const std::size_t column : columns_) {
          const cplx value =
              states[i][boundary](static_cast<Eigen::Index>(component), static_cast<Eigen::Index>(column));
          const double divisor = is_odd(component, column) && orders[i].n > 0.0 ? orders[i].n : 1.0;
          entries(row++, static_cast<Eigen::Index>(i)) = value / divisor;
        }
      }
    }
  }
  return entries;
}

bool DepthTransfer::is_resolved(const Panel<cplx>& panel) const {
  const double highest_n = std::sqrt(std::max(panel.high - m_ * m_, 1.0));
  // Stresses are of the size of their load; displacements are judged by the largest of them.
  double displacement = 0.0;
  const auto for_rows = [&](const auto& function) {
    Eigen::Index row = 0;
    for (std::size_t boundary = 0; boundary < boundaries_.size(); ++boundary) {
      for (std::size_t component = 0; component < kStates; ++component) {
        for (const std::size_t column : columns_) {
          function(row++, component < 3, is_odd(component, column) ? highest_n : 1.0);
        }
      }
    }
  };
  for_rows([&](Eigen::Index row, bool displaced, double scale) {
    if (displaced) displacement = std::max(displacement, scale * panel.series.row(row).cwiseAbs().maxCoeff());
  });
  bool resolved = true;
  for_rows([&](Eigen::Index row, bool displaced, double scale) {
    const double last = scale * panel.series.row(row).template tail<2>().cwiseAbs().maxCoeff();
    resolved = resolved && last <= tolerance_ * (displaced ? displacement : 1.0);
  });
  return resolved;
}

void DepthTransfer::evaluate(const Eigen::ArrayXd& n) {
  values_.resize(panels_.front().series.rows(), n.size());
  const Eigen::ArrayXd squares = m_ * m_ + n.square();
  Eigen::Index first = 0;
  Eigen::MatrixXd chebyshev;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> part;
  for (const Panel<cplx>& panel : panels_) {
    const double* end = std::upper_bound(squares.data() + first, squares.data() + squares.size(), panel.high);
    const Eigen::Index last = &panel == &panels_.back() ? squares.size() : end - squares.data();
    const Eigen::Index count = last - first;
    if (count == 0) continue;
    chebyshev.resize(kPanelNodes, count);
    chebyshev.row(0).setOnes();
    if (panel.low > 0.0) {
      const double scale = 2.0 / std::log(panel.high / panel.low);
      const Eigen::ArrayXd x = (squares.segment(first, count) / panel.low).log() * scale - 1.0;
      chebyshev.row(1) = x;
      for (int j = 2; j < kPanelNodes; ++j) {
        chebyshev.row(j) = 2.0 * x.transpose() * chebyshev.row(j - 1).array() - chebyshev.row(j - 2).array();
      }
    } else {
      chebyshev.bottomRows(kPanelNodes - 1).setZero();
    }
    part.noalias() = panel.series.real() * chebyshev;
    values_.middleCols(first, count).real() = part;
    part.noalias() = panel.series.imag() * chebyshev;
    values_.middleCols(first, count).imag() = part;
    first = last;
  }
}

void DepthTransfer::state(std::size_t boundary, const Eigen::ArrayXd& n, const LoadRows& loads,
                          ComponentRows& state) const {
  const Eigen::Index count = n.size();
  state.setZero(kStates, count);
  const auto orders = n.transpose().cast<cplx>();
  auto row = static_cast<Eigen::Index>(boundary * kStates * columns_.size());
  for (std::size_t component = 0; component < kStates; ++component) {
    auto sum = state.row(static_cast<Eigen::Index>(component));
    for (const std::size_t column : columns_) {
      const auto entry = values_.row(row++).head(count).array();
      const auto load = loads.row(static_cast<Eigen::Index>(column)).head(count);
      if (is_odd(component, column)) {
        sum += orders * entry * load;
      } else {
        sum += entry * load;
      }
    }
  }
}

}  // namespace viscoroll::detail
