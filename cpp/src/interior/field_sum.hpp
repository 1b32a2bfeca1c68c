/// @file
/// @brief Fields on surfaces r = const inside the layers, by sums over given orders.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "influence/order_bands.hpp"
#include "interior/depth_transfer.hpp"
#include "interior/inside.hpp"
#include "interior/load_spectrum.hpp"
#include "modal/depth_cut.hpp"
#include "modal/harmonic_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Orders of one direction, ascending, with their weights in the sum over orders of both signs.
struct WeightedOrders {
  Eigen::ArrayXd orders;
  Eigen::ArrayXd weights;

  explicit WeightedOrders(const std::vector<OrderBand>& bands) {
    std::vector<std::pair<double, double>> all;
    for (const OrderBand& band : bands) {
      for (Eigen::Index i = 0; i < band.orders.size(); ++i) all.emplace_back(band.orders[i], band.weights[i]);
    }
    std::ranges::sort(all);
    orders.resize(static_cast<Eigen::Index>(all.size()));
    weights.resize(orders.size());
    for (Eigen::Index i = 0; i < orders.size(); ++i) {
      std::tie(orders[i], weights[i]) = all[static_cast<std::size_t>(i)];
    }
  }

  /// @brief Orders, ascending, with their weights.
  WeightedOrders(Eigen::ArrayXd given_orders, Eigen::ArrayXd given_weights)
      : orders(std::move(given_orders)), weights(std::move(given_weights)) {}

  [[nodiscard]] Eigen::Index count_up_to(double highest) const {
    return std::ranges::upper_bound(orders, highest) - orders.begin();
  }
};

/// @brief Angles from the lowest point as magnitude and sign, since cosines and sines depend on the magnitude up to a
/// sign.
struct Angles {
  Eigen::ArrayXd magnitudes;         // ascending
  std::vector<Eigen::Index> number;  // index of the magnitude of each angle
  std::vector<bool> is_negative;     // whether each angle is negative

  explicit Angles(std::span<const double> angles) {
    std::vector<double> unique;
    constexpr double kSame = 1e-12;  // angles of mesh nodes have round-off
    for (const double angle : angles) unique.push_back(std::abs(angle));
    std::ranges::sort(unique);
    const auto repeated = std::ranges::unique(unique, [](double a, double b) { return b - a < kSame; });
    unique.erase(repeated.begin(), repeated.end());
    magnitudes = Eigen::Map<const Eigen::ArrayXd>(unique.data(), static_cast<Eigen::Index>(unique.size()));
    for (const double angle : angles) {
      number.push_back(std::ranges::upper_bound(unique, std::abs(angle) + kSame) - unique.begin() - 1);
      is_negative.push_back(angle < 0.0);
    }
  }
};

/// @brief Points of a surface r = const, as angles from the lowest point [rad]. Fields are on their grid.
struct Offsets {
  std::vector<double> phi;
  std::vector<double> theta;
};

/// @brief Orders of a sum over both directions.
struct SummedOrders {
  WeightedOrders m;
  WeightedOrders n;
  double measured_order;  ///< see `HarmonicBody`
  double decay;           ///< exponent of the decay with depth beyond which an order is left out
};

/// @brief Fields at given places and angles, summed over the orders n and then over the orders m.
class FieldSum {
 public:
  /// @param[in] inside body and its angular speed
  /// @param[in] places places along the normal, which must outlive this object
  /// @param[in] offsets points along the surface
  /// @param[in] orders orders of the sum
  /// @param[in] loads surface stresses at these orders
  FieldSum(const Inside& inside, std::span<const Place> places, Offsets offsets, SummedOrders orders,
           LoadSpectrum loads);

  /// @param[out] values row-major [place][component][phi][theta]
  /// @param[in] threads,watch threads, progress and cancellation
  void sum(double* values, int threads, Watch& watch) const;

 private:
  using Index = Eigen::Index;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Waves of every order n at every magnitude of theta.
  struct Waves {
    RowMajor cosines;
    RowMajor sines;
  };

  [[nodiscard]] std::vector<Mirror> mirrors() const;
  [[nodiscard]] std::vector<RowMajor> sum_along_theta(std::size_t first, std::size_t last, int threads,
                                                      Watch& watch) const;
  [[nodiscard]] bool is_line() const { return body_.metric().across == AxisKind::nothing; }
  [[nodiscard]] Index reach(double m, double limit) const;
  void add_order(Index i, std::size_t first, const DepthTransfer& transfer, const Waves& waves,
                 std::vector<RowMajor>& sums, const Worker& worker) const;
  [[nodiscard]] ComponentRows sum_over_n(const ComponentRows& basis, Mirror mirror, const Waves& waves) const;
  void sum_along_phi(const RowMajor& waves, double* values, const Worker& worker) const;
  void add_centrifugal(double* values) const;

  std::span<const Place> places_;
  LayerCuts cuts_;
  DepthLimit limit_;
  Offsets offsets_;
  Angles along_;
  Angles across_;
  WeightedOrders m_;
  WeightedOrders n_;
  double decay_;
  HarmonicBody body_;
  LoadSpectrum loads_;
};

}  // namespace viscoroll::detail
