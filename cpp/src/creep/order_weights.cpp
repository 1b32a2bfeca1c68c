#include "creep/order_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

#include "influence/synthesis.hpp"
#include "influence/table_sums.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using cplx = std::complex<double>;

/// Without inertia the speed affects only the frequencies of moduli, which are relaxed ones.
constexpr double kAnySpeed = 1.0;

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

/// @brief Weights C_0(k), C_1(k), ... of layers without inertia, as Chebyshev series in ln k^2.
class WeightPanels final : public OrderWeights {
 public:
  /// @param[in] layers of a sphere or a plane
  /// @param[in] lowest_m,highest_m,highest_n range of the orders
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  WeightPanels(const LayerSpectrum& layers, double lowest_m, double highest_m, double highest_n, int threads,
               Watch& watch);

  void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const override;

 private:
  std::vector<Panel<double>> panels_;  // row kFunctions * weight + function
};

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
    entry(Entry::rr) = row(kRadial).cast<cplx>();
    entry(Entry::rphi) = m * row(kMixed).cast<cplx>();
    entry(Entry::rtheta) = row(kMixed).cast<cplx>();
    entry(Entry::phiphi) = (row(kAcross) + m2 * row(kTurning)).cast<cplx>();
    entry(Entry::phitheta) = m * row(kTurning).cast<cplx>();
    entry(Entry::thetatheta) = (row(kAlong) - m2 * row(kTurning)).cast<cplx>();
  }
}

/// Rows of a weight: entries of each term in m^2 / k^2.
constexpr Index kPerWeight = Index{kEntries} * kPanelNodes;

/// Number of rows of the weights of one order, entry by entry.
Index rows_of(const LayerSpectrum& layers) { return kEntries * static_cast<Index>(layers.weights()); }

/// Weights of one order. Entries that are odd in n are divided by n, and those that are odd in m by m.
Eigen::VectorXd entries_of(const std::vector<Eigen::Matrix3d>& weights, double m, double n) {
  Eigen::VectorXd entries(kEntries * static_cast<Index>(weights.size()));
  for (std::size_t w = 0; w < weights.size(); ++w) {
    const Eigen::Matrix3d& y = weights[w];
    entries.segment<kEntries>(kEntries * static_cast<Index>(w)) << y(0, 0), y(0, 1) / m, y(0, 2) / n, y(1, 1),
        y(1, 2) / (m * n), y(2, 2);
  }
  return entries;
}

/// Whether the last terms are negligible compared with the relaxed compliance.
/// @param[in] panel rows (weight, any, entry), of which the first are at least as large as the others
/// @param[in] per_weight number of rows of each weight
/// @param[in] m_divisor divisor of entries that are odd in m
bool is_resolved(const Panel<double>& panel, Index per_weight, double m_divisor) {
  constexpr double kTolerance = 1e-11;  // sums around the contour keep twelve digits of the total
  const auto size = [&](Entry entry) {
    Eigen::RowVectorXd at_rest = Eigen::RowVectorXd::Zero(kPanelNodes);
    for (auto row = static_cast<Index>(entry); row < panel.series.rows(); row += per_weight) {
      at_rest += panel.series.row(row);
    }
    return at_rest.cwiseAbs().maxCoeff();
  };
  const auto sizes = entry_sizes(size(Entry::rr), size(Entry::phiphi), m_divisor, std::sqrt(panel.high));
  for (Index row = 0; row < panel.series.rows(); ++row) {
    const double last = panel.series.row(row).tail<2>().cwiseAbs().maxCoeff();
    if (last > kTolerance * sizes[static_cast<std::size_t>(row % kEntries)]) return false;
  }
  return true;
}

/// Panels of m = 0, where entries that are odd in m vanish.
std::vector<Panel<double>> panels_of_zero(const LayerSpectrum& layers, double highest_n) {
  constexpr double kAnything = 1.0;
  const auto sample = [&](const std::array<double, kPanelNodes>& k2) {
    std::vector<SurfaceOrder> orders;
    orders.reserve(k2.size());
    for (const double square : k2) orders.push_back({.m = 0.0, .n = std::sqrt(square)});
    const auto weights = layers.weights_of(orders);
    Eigen::MatrixXd values(rows_of(layers), kPanelNodes);
    for (std::size_t j = 0; j < k2.size(); ++j) {
      values.col(static_cast<Index>(j)) = entries_of(weights[j], kAnything, orders[j].n);
    }
    return values;
  };
  const SurfaceOrder uniform{.m = 0.0, .n = 0.0};
  const double lowest = end_of_zero_order(layers.metric());
  std::vector<Panel<double>> panels;
  append_constants(lowest, entries_of(layers.weights_of(std::span(&uniform, 1)).front(), kAnything, kAnything), panels);
  append_panels(
      lowest, highest_n * highest_n, sample,
      [&](const Panel<double>& panel) { return is_resolved(panel, kEntries, kAnything); }, panels);
  return panels;
}

/// Chebyshev nodes of m^2 / k^2 between 0 and 1.
double direction(int node) { return 0.5 + 0.5 * std::cos(std::numbers::pi * (node + 0.5) / kPanelNodes); }

/// Weights at nodes in k^2, as series in m^2 / k^2.
Eigen::MatrixXd directions_at(const LayerSpectrum& layers, const std::array<double, kPanelNodes>& k2) {
  static const Eigen::MatrixXd transform = chebyshev_transform(kPanelNodes);
  Eigen::MatrixXd values(kPanelNodes * rows_of(layers), kPanelNodes);
  for (std::size_t j = 0; j < k2.size(); ++j) {
    std::vector<SurfaceOrder> orders;
    orders.reserve(kPanelNodes);
    for (int i = 0; i < kPanelNodes; ++i) {
      orders.push_back({.m = std::sqrt(direction(i) * k2[j]), .n = std::sqrt((1.0 - direction(i)) * k2[j])});
    }
    const auto weights = layers.weights_of(orders);
    Eigen::MatrixXd around(rows_of(layers), kPanelNodes);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      around.col(static_cast<Index>(i)) = entries_of(weights[i], orders[i].m, orders[i].n);
    }
    for (std::size_t w = 0; w < layers.weights(); ++w) {
      const auto number = static_cast<Index>(w);
      values.col(static_cast<Index>(j)).segment<kPerWeight>(kPerWeight * number) =
          (around.middleRows<kEntries>(kEntries * number) * transform).reshaped();
    }
  }
  return values;
}

/// Chebyshev polynomials T_0, T_1, ... at x.
Eigen::Vector<double, kPanelNodes> chebyshev_polynomials(double x) {
  Eigen::Vector<double, kPanelNodes> values;
  values[0] = 1.0;
  values[1] = x;
  for (Index i = 2; i < values.size(); ++i) values[i] = 2.0 * x * values[i - 1] - values[i - 2];
  return values;
}

double coordinate(const Panel<double>& panel, double k2) {
  return 2.0 * std::log(k2 / panel.low) / std::log(panel.high / panel.low) - 1.0;
}

/// Entries of one weight of an order m at k^2.
Eigen::Vector<double, kEntries> value_at(const Panel<double>& panel, std::size_t weight, double m2, double k2) {
  const auto rows = panel.series.middleRows<kPerWeight>(kPerWeight * static_cast<Index>(weight));
  const Eigen::Vector<double, kPerWeight> at_k2 = rows * chebyshev_polynomials(coordinate(panel, k2));
  return at_k2.reshaped(kEntries, kPanelNodes) * chebyshev_polynomials(2.0 * m2 / k2 - 1.0);
}

void append(const Panel<double>& panel, OrderSeries& series) {
  series.push_back({.low = panel.low, .high = panel.high, .series = panel.series.cast<cplx>()});
}

/// @brief Weights C_0(m, n), C_1(m, n), ... of layers without inertia. At a given k^2 = m^2 + n^2 they vary little with
/// the direction of k and are nearly polynomials in m^2 / k^2. They are stored as Chebyshev series in m^2 / k^2 and in
/// ln k^2; for m = 0, in ln k^2 only.
class WheelWeights final : public OrderWeights {
 public:
  /// @param[in] layers layers of a wheel, or of a cylinder under one
  /// @param[in] highest_m,highest_n range of the orders; m is 0 or at least 1
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  WheelWeights(const LayerSpectrum& layers, double highest_m, double highest_n, int threads, Watch& watch);

  void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const override;

 private:
  std::vector<Panel<double>> zero_;    // m = 0: row (weight, entry)
  std::vector<Panel<double>> panels_;  // row (weight, term in m^2 / k^2, entry)
};

WheelWeights::WheelWeights(const LayerSpectrum& layers, double highest_m, double highest_n, int threads, Watch& watch) {
  constexpr double kPart = 16.0;  // ratio of k^2 that one thread resolves
  const double most = highest_m * highest_m + highest_n * highest_n;
  std::vector<double> bounds{1.0};
  while (bounds.back() < most) bounds.push_back(std::min(kPart * bounds.back(), most));
  std::vector<std::vector<Panel<double>>> parts(bounds.size());
  parallel_for(parts.size(), threads, watch, "solving layers", [&](std::size_t p, const Worker& worker) {
    if (p + 1 == parts.size()) {
      zero_ = panels_of_zero(layers, highest_n);
      return;
    }
    append_panels(
        bounds[p], bounds[p + 1],
        [&](const auto& k2) {
          worker.checkpoint();
          return directions_at(layers, k2);
        },
        [&](const Panel<double>& panel) { return is_resolved(panel, kPerWeight, std::sqrt(panel.high)); }, parts[p]);
  });
  for (auto& part : parts) std::ranges::move(part, std::back_inserter(panels_));
}

void WheelWeights::series(std::size_t weight, double m, double highest_n, OrderSeries& series) const {
  // Powers of m^2 / k^2 vary over a panel; sixteen terms represent them over this ratio of k^2.
  constexpr double kRatio = 3.0;
  series.clear();
  const double highest = m * m + highest_n * highest_n;
  if (m == 0.0) {
    for (const Panel<double>& panel : zero_) {
      if (panel.low > highest) break;
      append({panel.low, panel.high, panel.series.middleRows<kEntries>(kEntries * static_cast<Index>(weight))}, series);
      series.back().series.row(static_cast<int>(Entry::rphi)).setZero();
      series.back().series.row(static_cast<int>(Entry::phitheta)).setZero();
    }
    return;
  }
  for (const Panel<double>& panel : panels_) {
    if (panel.high <= m * m || panel.low > highest) continue;
    const double start = std::max(panel.low, m * m);
    const int count = std::max(1, static_cast<int>(std::ceil(std::log(panel.high / start) / std::log(kRatio))));
    for (int part = 0; part < count; ++part) {
      const double low = start * std::pow(panel.high / start, static_cast<double>(part) / count);
      const double high = start * std::pow(panel.high / start, (part + 1.0) / count);
      const auto k2 = panel_nodes(low, high);
      Eigen::Matrix<double, Eigen::Dynamic, kPanelNodes> values(kEntries, kPanelNodes);
      for (std::size_t j = 0; j < k2.size(); ++j) {
        values.col(static_cast<Index>(j)) = value_at(panel, weight, m * m, k2[j]);
      }
      for (const Entry odd : {Entry::rphi, Entry::phitheta}) values.row(static_cast<int>(odd)) *= m;
      append({low, high, to_series(values)}, series);
    }
  }
}

/// @brief Spectrum of one weight.
class WeightSpectrum final : public Spectrum {
 public:
  /// @param[in] weights all weights
  /// @param[in] weight number of the weight
  /// @param[in] orders orders m
  /// @param[in] highest_n largest order n that is evaluated
  WeightSpectrum(std::shared_ptr<const OrderWeights> weights, std::size_t weight, std::vector<double> orders,
                 double highest_n)
      : weights_(std::move(weights)), weight_(weight), orders_(std::move(orders)), highest_n_(highest_n) {}

  void series(std::size_t i, OrderSeries& series) const override {
    weights_->series(weight_, orders_[i], highest_n_, series);
  }

 private:
  std::shared_ptr<const OrderWeights> weights_;
  std::size_t weight_;
  std::vector<double> orders_;
  double highest_n_;
};

}  // namespace

std::shared_ptr<const OrderWeights> order_weights(const LayerSpectrum& layers, const std::vector<double>& m,
                                                  double highest_n, int threads, Watch& watch) {
  const auto [lowest_m, highest_m] = std::ranges::minmax(m);
  if (layers.metric().is_wheel()) {
    return std::make_shared<const WheelWeights>(layers, highest_m, highest_n, threads, watch);
  }
  return std::make_shared<const WeightPanels>(layers, lowest_m, highest_m, highest_n, threads, watch);
}

std::vector<std::unique_ptr<const TableSum>> weights_under_spot(const LayerSpectrum& layers, const MeshOnBody& mesh,
                                                                int threads, Watch& watch) {
  const LayeredBody& body = layers.body_at_rest();
  const std::vector<OrderBand> along = phi_bands(body, kAnySpeed, mesh.rounded());
  const std::vector<OrderBand> across = theta_bands(body, kAnySpeed, mesh.rounded(), 0.0, mesh.widest());
  const std::vector<double> m = all_orders(along);
  const double highest_n = std::ranges::max(all_orders(across));
  const std::shared_ptr<const OrderWeights> weights = order_weights(layers, m, highest_n, threads, watch);
  std::vector<std::unique_ptr<const TableSum>> sums;
  sums.reserve(layers.weights());
  for (std::size_t w = 0; w < layers.weights(); ++w) {
    sums.push_back(std::make_unique<const OrderSum>(mesh, layers.metric().radius, along, across,
                                                    std::make_unique<WeightSpectrum>(weights, w, m, highest_n)));
  }
  return sums;
}

std::vector<std::unique_ptr<const TableSum>> weights_under_line(const LayerSpectrum& layers, const MeshOnBody& mesh,
                                                                int threads, Watch& watch) {
  constexpr std::size_t kBlock = 16;  // orders that are solved together
  // Each order is solved separately, because there are few.
  const std::vector<OrderBand> bands = phi_bands(layers.body_at_rest(), kAnySpeed, mesh.rounded());
  const std::vector<double> m = all_orders(bands);
  std::vector<std::vector<Eigen::Matrix3cd>> spectra(layers.weights(), std::vector<Eigen::Matrix3cd>(m.size()));
  parallel_for((m.size() + kBlock - 1) / kBlock, threads, watch, "solving layers",
               [&](std::size_t block, const Worker&) {
                 const std::size_t first = block * kBlock;
                 std::vector<SurfaceOrder> orders;
                 for (std::size_t i = first; i < std::min(first + kBlock, m.size()); ++i) {
                   orders.push_back({.m = m[i], .n = 0.0});
                 }
                 const auto weights = layers.weights_of(orders);
                 for (std::size_t i = 0; i < orders.size(); ++i) {
                   for (std::size_t w = 0; w < layers.weights(); ++w) {
                     spectra[w][first + i] = weights[i][w].cast<cplx>();
                   }
                 }
               });
  std::vector<std::unique_ptr<const TableSum>> sums;
  sums.reserve(layers.weights());
  for (auto& spectrum : spectra) {
    sums.push_back(std::make_unique<const LineSum>(bands, std::move(spectrum), layers.metric().radius, mesh));
  }
  return sums;
}

}  // namespace viscoroll::detail
