/// @file
/// @brief Spectrum of any body: sampled in both directions of order, where its moduli are smooth.
#pragma once

#include <memory>
#include <vector>

#include "modal/measured_moduli.hpp"
#include "modal/order_by_order.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Chebyshev series in two variables, ln m and ln(k^2 / m^2), k^2 = m^2 + n^2.
///
/// Multiplied by m and the modulus of the outer layer, the compliance is as smooth in ln m as it is in ln k: moduli of
/// frequency have their poles and cuts where ln m is half of pi off the real axis. So some 24 solutions stand for as
/// many orders m as there are in three octaves. Measured moduli have kinks, between which 6 to 24 solutions stand for
/// the orders. Orders that lie less closely are solved one by one.
class OrderPanels final : public Spectrum {
 public:
  /// @param[in] body layers at the orders m
  /// @param[in] highest_n largest order n that is asked for
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  OrderPanels(std::shared_ptr<const HarmonicBody> body, double highest_n, int threads, Watch& watch);

  void series(std::size_t i, OrderSeries& series) const override;

  /// @brief Orders, from one to the next, over which the moduli are smooth.
  struct SmoothRun {
    double lowest_m = 0.0;
    double highest_m = 0.0;
    std::size_t count = 0;
    MeasuredModuli measured;
    int nodes = 0;  ///< Chebyshev nodes in ln m that are thought to resolve the compliance
  };

  /// @brief Series on a range of m and one of k^2 / m^2.
  struct Cell {
    double lowest_m;
    double highest_m;
    double lowest_ratio;
    double highest_ratio;
    /// Row i holds the coefficients of T_i in ln m: kPanelNodes in ln(k^2 / m^2) for each entry.
    Eigen::Matrix<std::complex<double>, Eigen::Dynamic, kEntries * kPanelNodes, Eigen::RowMajor> series;
  };

 private:
  struct Range {
    SmoothRun run;
    std::vector<Cell> cells;  ///< at any m in the order of k^2 / m^2
  };

  void find_ranges();
  [[nodiscard]] const Range* range_of(double m) const;

  std::shared_ptr<const HarmonicBody> body_;
  OrderByOrderSpectrum one_by_one_;
  std::vector<Range> ranges_;
};

}  // namespace viscoroll::detail
