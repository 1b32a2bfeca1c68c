/// @file
/// @brief Approximate inverse of a convolution, as a preconditioner.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/parallel.hpp"
#include "influence/convolution.hpp"
#include "influence/node_rows.hpp"
#include "influence/spectral_product.hpp"
#include "influence/table.hpp"

namespace viscoroll::detail {

/// @brief Inverse of the convolution with tables that are made periodic, see `PeriodicTable`.
class InverseConvolution {
 public:
  /// @param[in] shape window
  /// @param[in] period period of the domain, from the window to the doubled window; a longer one is more accurate and
  /// costs more
  /// @param[in] tables tables that reach across the window
  /// @param[in] terms terms of a convolution with as many fields as results
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  InverseConvolution(WindowShape shape, WindowShape period, const std::vector<const Table*>& tables,
                     const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch);

  /// @param[in] fields fields over the window, one column each
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return fields whose convolution is approximately `fields`
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& fields, int threads, Watch& watch) const;

  /// @brief Same for a single field that is given and evaluated only at some nodes.
  /// @param[in] nodes these nodes
  /// @param[in] values values of the field at these nodes
  /// @param[in] threads,watch same as above
  [[nodiscard]] Eigen::VectorXd apply(const NodeRows& nodes, const Eigen::VectorXd& values, int threads,
                                      Watch& watch) const;

 private:
  SpectralProduct product_;
  std::size_t fields_ = 0;
  std::vector<ComplexBuffer> inverse_symbol_;  // row by row
  std::vector<SpectralTerm> terms_;
};

}  // namespace viscoroll::detail
