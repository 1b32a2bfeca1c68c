/// @file
/// @brief Approximate inverse of a convolution, for preconditioning.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "influence/convolution.hpp"
#include "influence/node_rows.hpp"
#include "influence/spectral_product.hpp"
#include "influence/table.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Inverse of the convolution with tables made periodic, see `PeriodicTable`.
class InverseConvolution {
 public:
  /// @param[in] shape window
  /// @param[in] period of the domain, from the window to the doubled window: the longer, the better and dearer
  /// @param[in] tables that reach across the window
  /// @param[in] terms of a convolution of as many fields as results
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  InverseConvolution(WindowShape shape, WindowShape period, const std::vector<const Table*>& tables,
                     const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch);

  /// @param[in] fields over the window, a column for each
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return other ones, whose convolution is about `fields`
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& fields, int threads, Watch& watch) const;

  /// @brief The same for a single field that is given and wanted at some nodes alone.
  /// @param[in] nodes where
  /// @param[in] values of the field there
  [[nodiscard]] Eigen::VectorXd apply(const NodeRows& nodes, const Eigen::VectorXd& values, int threads,
                                      Watch& watch) const;

 private:
  SpectralProduct product_;
  std::size_t fields_ = 0;
  std::vector<ComplexBuffer> inverse_symbol_;  // row by row
  std::vector<SpectralTerm> terms_;
};

}  // namespace viscoroll::detail
