/// @file
/// @brief A table that is tapered to a window and made periodic.
#pragma once

#include <cstdlib>

#include "influence/spectral_product.hpp"
#include "influence/table.hpp"

namespace viscoroll::detail {

/// @brief Table times a triangle in each direction, summed over the offsets that are equal modulo the period.
///
/// The triangle weights an offset by the number of pairs of nodes at it. It keeps the Hermitian part of the symbol
/// positive if that of the convolution is (Fejer), so that the inverse symbol does not divide by small numbers. On a
/// period as long as the window it gives T. F. Chan's optimal circulant (SIAM J. Sci. Stat. Comput. 9 (1988) 766-771).
class PeriodicTable {
 public:
  /// @param[in] table table that reaches across the window and outlives this object
  /// @param[in] shape window
  /// @param[in] period period, from the window to the doubled window
  PeriodicTable(const Table& table, WindowShape shape, WindowShape period)
      : table_(table), shape_(shape), period_(period) {}

  /// @return value at a place of the period
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
