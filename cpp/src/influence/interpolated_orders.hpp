/// @file
/// @brief Few orders at which a smooth compliance is found for sums over many, docs/theory/influence-tables.md.
///
/// Over some octaves the compliance is a polynomial in the logarithm of the order, to the last digits, while the waves
/// and patches oscillate that it is multiplied by in a sum. These are known: they are summed with the polynomials once
/// for all, and the compliance is asked for at the nodes of the polynomials alone.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "influence/order_bands.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {

/// @brief The orders of some bands, and those that stand for them. Low orders, and ranges that hold few, stand for
/// themselves.
class InterpolatedOrders {
 public:
  /// @brief Sampled orders in a row, the nodes of polynomials or orders of the bands themselves.
  struct Range {
    Eigen::Index first;
    Eigen::Index count;
    bool is_interpolated;
    Eigen::Matrix2Xd last_terms;  ///< [2, node] of a Chebyshev series by values at the nodes
  };

  explicit InterpolatedOrders(const std::vector<OrderBand>& bands);

  /// @return ascending
  [[nodiscard]] const Eigen::ArrayXd& sampled() const { return sampled_; }
  [[nodiscard]] const std::vector<Range>& ranges() const { return ranges_; }

  /// @brief Sum over the orders of a band what each sampled order has to be multiplied by.
  /// @param[in] terms of the band, [order, offset]
  /// @param[in,out] sums [sampled order, offset], of as many offsets at least
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
    std::vector<Eigen::Index> places;  // of orders that stand for themselves
  };

  void append_polynomials(double low, double high, const std::vector<OrderBand>& bands);
  void append_themselves(double low, double high, const std::vector<OrderBand>& bands);

  Eigen::ArrayXd sampled_;
  std::vector<Range> ranges_;
  std::vector<std::vector<Part>> parts_;  // [band]
};

}  // namespace viscoroll::detail
