/// @file
/// @brief Spectrum of any body that is sampled in m and n where the moduli are smooth.
#pragma once

#include <memory>
#include <vector>

#include "modal/measured_moduli.hpp"
#include "modal/order_by_order.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Chebyshev series in two variables, ln m and ln(k^2 / m^2), with k^2 = m^2 + n^2.
///
/// Multiplied by m and by the modulus of the outer layer, the compliance is as smooth in ln m as in ln k: a modulus has
/// its poles and branch cuts where ln m is pi/2 off the real axis. About 24 solutions therefore represent all orders m
/// in three octaves. Measured moduli have kinks; 6 to 24 solutions represent the orders between two kinks. Runs with
/// fewer orders are solved order by order.
class OrderPanels final : public Spectrum {
 public:
  /// @param[in] body layers at the orders m
  /// @param[in] highest_n largest order n that is evaluated
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  OrderPanels(std::shared_ptr<const HarmonicBody> body, double highest_n, int threads, Watch& watch);

  void series(std::size_t i, OrderSeries& series) const override;

  /// @brief Consecutive orders over which the moduli are smooth.
  struct SmoothRun {
    double lowest_m = 0.0;
    double highest_m = 0.0;
    std::size_t count = 0;
    MeasuredModuli measured;
    int nodes = 0;  ///< estimated number of Chebyshev nodes in ln m that resolve the compliance
  };

  /// @brief Series on a range of m and a range of k^2 / m^2.
  struct Cell {
    double lowest_m;
    double highest_m;
    double lowest_ratio;
    double highest_ratio;
    /// Row i contains the coefficients of T_i in ln m: kPanelNodes coefficients in ln(k^2 / m^2) for each entry.
    Eigen::Matrix<std::complex<double>, Eigen::Dynamic, kEntries * kPanelNodes, Eigen::RowMajor> series;
  };

 private:
  struct Range {
    SmoothRun run;
    std::vector<Cell> cells;  ///< at every m in ascending order of k^2 / m^2
  };

  void find_ranges();
  [[nodiscard]] const Range* range_of(double m) const;

  std::shared_ptr<const HarmonicBody> body_;
  OrderByOrderSpectrum one_by_one_;
  std::vector<Range> ranges_;
};

}  // namespace viscoroll::detail
