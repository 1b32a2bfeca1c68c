#include "transient/weight_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// Functions that represent each weight: r by r, r by the direction of k divided by k, across k, along k, and the
/// difference of the last two divided by k^2, which turns with the direction of k.
enum Function : std::uint8_t { kRadial, kMixed, kAcross, kAlong, kTurning };
constexpr Index kFunctions = 5;

Index row_of(std::size_t weight, Function function) { return kFunctions * static_cast<Index>(weight) + function; }

/// Functions at orders with n = 0, where the directions are r, k and across k.
Eigen::MatrixXd functions_at(const LayerSpectrum& layers, const std::array<double, kPanelNodes>& k2) {
  std::vector<SurfaceOrder> orders;
  orders.reserve(k2.size());
  for (const double square : k2) orders.push_back({.m = std::sqrt(square), .n = 0.0});
  const auto weights = layers.weights_of(orders);
  Eigen::MatrixXd values(kFunctions * static_cast<Index>(layers.weights()), kPanelNodes);
  for (std::size_t i = 0; i < k2.size(); ++i) {
    for (std::size_t w = 0; w < layers.weights(); ++w) {
      const Eigen::Matrix3d& y = weights[i][w];
      values.col(static_cast<Index>(i)).segment<kFunctions>(row_of(w, kRadial)) << y(0, 0), y(0, 1) / std::sqrt(k2[i]),
          y(2, 2), y(1, 1), (y(1, 1) - y(2, 2)) / k2[i];
    }
  }
  return values;
}

/// Functions at order (0, 0), which has no direction.
Eigen::VectorXd functions_at_zero(const LayerSpectrum& layers) {
  const SurfaceOrder zero{.m = 0.0, .n = 0.0};
  const auto weights = layers.weights_of(std::span(&zero, 1)).front();
  Eigen::VectorXd values(kFunctions * static_cast<Index>(layers.weights()));
  for (std::size_t w = 0; w < weights.size(); ++w) {
    const Eigen::Matrix3d& y = weights[w];
    values.segment<kFunctions>(row_of(w, kRadial)) << y(0, 0), 0.0, y(2, 2), y(1, 1), 0.0;
  }
  return values;
}

/// Whether the last terms of all functions are negligible compared with the relaxed compliance.
bool is_resolved(const Panel<double>& panel) {
  constexpr double kTolerance = 1e-11;  // sums around the contour keep twelve digits of the total
  const Index weights = panel.series.rows() / kFunctions;
  const auto size = [&](Function function) {
    Eigen::RowVectorXd at_rest = Eigen::RowVectorXd::Zero(kPanelNodes);
    for (Index w = 0; w < weights; ++w) at_rest += panel.series.row(kFunctions * w + function);
    return at_rest.cwiseAbs().maxCoeff();
  };
  const double radial = size(kRadial);
  const double along = size(kAlong);
  const std::array<double, kFunctions> sizes{radial, std::sqrt(radial * along / panel.high), size(kAcross), along,
                                             along / panel.high};
  for (Index row = 0; row < panel.series.rows(); ++row) {
    const double last = panel.series.row(row).tail<2>().cwiseAbs().maxCoeff();
    if (last > kTolerance * sizes[static_cast<std::size_t>(row % kFunctions)]) return false;
  }
  return true;
}

}  // namespace

WeightPanels::WeightPanels(const LayerSpectrum& layers, double lowest_m, double highest_m, double highest_n,
                           int threads, Watch& watch) {
  constexpr double kPart = 64.0;  // ratio of k^2 that one thread resolves
  const double most = highest_m * highest_m + highest_n * highest_n;
  const bool is_sphere = layers.metric().is_sphere();
  std::vector<double> bounds{is_sphere ? kZeroOrder : lowest_m * lowest_m};
  if (is_sphere) append_constants(kZeroOrder, functions_at_zero(layers), panels_);
  if (is_sphere && most > kLowOrders) bounds.push_back(kLowOrders);
  while (bounds.back() < most) bounds.push_back(std::min(kPart * bounds.back(), most));
  std::vector<std::vector<Panel<double>>> parts(bounds.size() - 1);
  parallel_for(parts.size(), threads, watch, "solving layers", [&](std::size_t p, const Worker& worker) {
    append_panels(
        bounds[p], bounds[p + 1],
        [&](const auto& nodes) {
          worker.checkpoint();
          return functions_at(layers, nodes);
        },
        is_resolved, parts[p]);
  });
  for (auto& part : parts) std::ranges::move(part, std::back_inserter(panels_));
}

void WeightPanels::series(std::size_t weight, double m, double highest_n, OrderSeries& series) const {
  const double m2 = m * m;
  series.clear();
  for (const Panel<double>& panel : panels_) {
    if (panel.high < m2 || panel.low > m2 + highest_n * highest_n) continue;
    const auto row = [&](Function function) { return panel.series.row(row_of(weight, function)); };
    series.push_back({.low = panel.low, .high = panel.high, .series = {}});
    auto& target = series.back().series;
    target.resize(kEntries, kPanelNodes);
    const auto entry = [&](Entry which) { return target.row(static_cast<int>(which)); };
    entry(Entry::rr) = row(kRadial).cast<std::complex<double>>();
    entry(Entry::rphi) = m * row(kMixed).cast<std::complex<double>>();
    entry(Entry::rtheta) = row(kMixed).cast<std::complex<double>>();
    entry(Entry::phiphi) = (row(kAcross) + m2 * row(kTurning)).cast<std::complex<double>>();
    entry(Entry::phitheta) = m * row(kTurning).cast<std::complex<double>>();
    entry(Entry::thetatheta) = (row(kAlong) - m2 * row(kTurning)).cast<std::complex<double>>();
  }
}

}  // namespace viscoroll::detail
