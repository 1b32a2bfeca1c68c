/// @file
/// @brief Approximate inverse of a table's convolution, for preconditioning.
#pragma once

#include <Eigen/Core>

#include "influence/spectral_product.hpp"
#include "influence/table.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Inverse of the periodic convolution nearest to a table's, on the window itself: T. F. Chan's optimal circulant
/// (SIAM J. Sci. Stat. Comput. 9 (1988) 766-771) in both directions, whose symbol has a positive real part where the
/// table's convolution has a positive symmetric part.
class InverseConvolution {
 public:
  /// @param[in] shape window
  /// @param[in] table compliance that reaches across it
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  InverseConvolution(WindowShape shape, const Table& table, int threads, Watch& watch);

  /// @param[in] field over the window
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return another one, whose convolution with the table is about `field`
  [[nodiscard]] Eigen::ArrayXd apply(const Eigen::ArrayXd& field, int threads, Watch& watch) const;

 private:
  SpectralProduct product_;
  ComplexBuffer inverse_symbol_;
};

}  // namespace viscoroll::detail
