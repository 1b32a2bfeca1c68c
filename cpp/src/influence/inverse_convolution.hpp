/// @file
/// @brief Approximate inverse of a table's convolution, for preconditioning.
#pragma once

#include <Eigen/Core>

#include "influence/convolution.hpp"
#include "influence/fft.hpp"
#include "influence/synthesis.hpp"

namespace viscoroll::detail {

/// @brief Division by the symbol of a table on the window doubled in both directions and made periodic.
class InverseConvolution {
 public:
  /// @param[in] shape window; the table reaches across it
  /// @param[in] table compliance whose symbol has a positive real part but for what periodicity does to it
  InverseConvolution(WindowShape shape, const Table& table);

  /// @param[in] field over the window
  /// @return another one, whose convolution with the table is about `field`
  [[nodiscard]] Eigen::ArrayXd apply(const Eigen::ArrayXd& field) const;

 private:
  WindowShape shape_;
  int padded_phi_;
  int padded_theta_;
  RealFft fft_;
  ComplexBuffer inverse_symbol_;
};

}  // namespace viscoroll::detail
