/// @file
/// @brief A table that is tapered to a window and made periodic.
#pragma once

#include <cstdlib>

#include "influence/spectral_product.hpp"
#include "influence/table.hpp"

namespace viscoroll::detail {

/// @brief Sum, over the offsets that a period cannot tell apart, of a table times a triangle in each direction.
///
/// The triangle weighs an offset by the pairs of nodes at it. It keeps the symbol's Hermitian part positive where the
/// convolution's is (Fejer), so that nothing small is divided by where the symbol is inverted; on a period as long as
/// the window it makes T. F. Chan's optimal circulant (SIAM J. Sci. Stat. Comput. 9 (1988) 766-771).
class PeriodicTable {
 public:
  /// @param[in] table that reaches across the window, and outlives this object
  /// @param[in] shape window
  /// @param[in] period from the window to the doubled window
  PeriodicTable(const Table& table, WindowShape shape, WindowShape period)
      : table_(table), shape_(shape), period_(period) {}

  /// @return the value at a place of the period
  [[nodiscard]] double operator()(int row, int column) const {
    const int j = row - period_.phi_nodes;
    const int l = column - period_.theta_nodes;
    return tapered(row, column) + tapered(row, l) + tapered(j, column) + tapered(j, l);
  }

 private:
  [[nodiscard]] double tapered(int j, int l) const {
    const double ahead = 1.0 - std::abs(j) / static_cast<double>(shape_.phi_nodes);
    const double aside = 1.0 - std::abs(l) / static_cast<double>(shape_.theta_nodes);
    return ahead > 0.0 && aside > 0.0 ? ahead * aside * table_(j, l) : 0.0;
  }

  const Table& table_;
  WindowShape shape_;
  WindowShape period_;
};

}  // namespace viscoroll::detail
