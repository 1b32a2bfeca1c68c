/// @file
/// @brief Few sampled orders from which a smooth compliance is summed over many orders
/// (docs/theory/influence-tables.md).
///
/// Over some octaves the compliance is a polynomial in the logarithm of the order, to the last digits. In a sum it
/// multiplies waves and patches, which oscillate but are known in advance. Their sums with the polynomials are computed
/// once, and the compliance is evaluated only at the nodes of the polynomials.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "influence/order_bands.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {

/// @brief Orders of some bands and the sampled orders that replace them. Low orders, and ranges with few orders, are
/// sampled themselves.
class InterpolatedOrders {
 public:
  /// @brief Consecutive sampled orders: nodes of polynomials, or orders of the bands.
  struct Range {
    Eigen::Index first;
    Eigen::Index count;
    bool is_interpolated;
    Eigen::Matrix2Xd last_terms;  ///< [2, node], last two terms of a Chebyshev series from values at the nodes
  };

  explicit InterpolatedOrders(const std::vector<OrderBand>& bands);

  /// @return sampled orders, ascending
  [[nodiscard]] const Eigen::ArrayXd& sampled() const { return sampled_; }
  [[nodiscard]] const std::vector<Range>& ranges() const { return ranges_; }

  /// @brief Sum, over the orders of a band, the factors of each sampled order.
  /// @param[in] band index of the band
  /// @param[in] terms terms of the band, [order, offset]
  /// @param[in,out] sums [sampled order, offset], with at least as many offsets
  void add_sums(std::size_t band, const RowMajorMatrix& terms, RowMajorMatrix& sums) const;

  /// @return whether a band has orders in a range
  [[nodiscard]] bool has_orders(std::size_t band, std::size_t range) const;

 private:
  /// Orders of a band in a range.
  struct Part {
    std::size_t range;
    Eigen::Index first;
    Eigen::Index count;
    RowMajorMatrix basis;              // [node, order]
    std::vector<Eigen::Index> places;  // indices of orders that are sampled themselves
  };

  void append_polynomials(double low, double high, const std::vector<OrderBand>& bands);
  void append_orders(double low, double high, const std::vector<OrderBand>& bands);

  Eigen::ArrayXd sampled_;
  std::vector<Range> ranges_;
  std::vector<std::vector<Part>> parts_;  // [band]
};

}  // namespace viscoroll::detail
