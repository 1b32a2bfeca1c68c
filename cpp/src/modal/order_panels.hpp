/// @file
/// @brief Spectrum of any surface whose moduli are smooth: sampled in both directions of order.
#pragma once

#include <memory>
#include <vector>

#include "modal/order_by_order.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Chebyshev series in two variables, ln m and ln(k^2 / m^2), k^2 = m^2 + n^2.
///
/// Multiplied by m and the modulus of the outer layer, the compliance is as smooth in ln m as it is in ln k: moduli of
/// frequency have their poles and cuts where ln m is half of pi off the real axis. So some 24 solutions stand for as
/// many orders m as there are in three octaves. Orders that lie less closely are solved one by one.
class OrderPanels final : public Spectrum {
 public:
  /// @param[in] surface layers at the orders m, with smooth moduli
  /// @param[in] lowest_m from which on series stand for orders
  /// @param[in] highest_n largest order n that is asked for
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  OrderPanels(std::shared_ptr<const LayeredSurface> surface, double lowest_m, double highest_n, int threads,
              Watch& watch);

  void series(std::size_t i, OrderSeries& series) const override;

  static constexpr int kOrderNodes = 24;  ///< Chebyshev nodes, and so terms, in ln m

  /// @brief Series on a range of m and one of k^2 / m^2.
  struct Cell {
    double lowest_m;
    double highest_m;
    double lowest_ratio;
    double highest_ratio;
    /// Row i holds the coefficients of T_i in ln m: kPanelNodes in ln(k^2 / m^2) for each entry.
    Eigen::Matrix<std::complex<double>, kOrderNodes, kEntries * kPanelNodes, Eigen::RowMajor> series;
  };

 private:
  /// @brief Range of m.
  struct Range {
    double lowest_m;
    double highest_m;
    std::vector<Cell> cells;  ///< at any m in the order of k^2 / m^2
  };

  [[nodiscard]] const Range* range_of(double m) const;

  std::shared_ptr<const LayeredSurface> surface_;
  OrderByOrderSpectrum one_by_one_;
  std::vector<Range> ranges_;
};

}  // namespace viscoroll::detail
