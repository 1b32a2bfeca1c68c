#include "modal/order_by_order.hpp"

#include <array>
#include <cmath>
#include <span>

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

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

}  // namespace

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

}  // namespace viscoroll::detail
