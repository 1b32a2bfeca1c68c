/// @file
/// @brief Products of influence tables and fields on a window, node by node, for few loaded nodes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/convolution.hpp"

namespace viscoroll::detail {

/// @brief Products of a `Convolution` as sums over the loaded nodes. For small contacts this takes less time and no
/// spectra. An object computes one product at a time.
class TableProduct {
 public:
  using Tables = std::shared_ptr<const std::vector<Table>>;

  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables all tables; only those in `terms` are used
  /// @param[in] terms summands
  TableProduct(WindowShape shape, Tables tables, std::vector<ConvolutionTerm> terms);

  /// @brief Compute a product with functions that fill and take rows, see `SpectralProduct`, if it takes less time than
  /// transforms.
  /// @return whether the product was computed; if not, `take` was not called
  [[nodiscard]] bool apply(std::size_t fields, const SpectralProduct::Fill& fill,
                           const SpectralProduct::Take& take) const;

  [[nodiscard]] const std::vector<ConvolutionTerm>& terms() const { return terms_; }

  /// @param[in] table index of a table
  /// @param[in] displaced,loaded nodes of the window
  /// @return values of the table, one row per displaced and one column per loaded node
  [[nodiscard]] Eigen::MatrixXd between(std::size_t table, const std::vector<Eigen::Index>& displaced,
                                        const std::vector<Eigen::Index>& loaded) const;

 private:
  [[nodiscard]] bool is_quick_by_nodes(const Eigen::ArrayXXd& operands) const;
  [[nodiscard]] Eigen::ArrayXXd by_nodes(const Eigen::ArrayXXd& operands) const;
  [[nodiscard]] const Eigen::ArrayXXd& unfolded(std::size_t table) const;

  WindowShape shape_;
  Tables tables_;
  std::vector<ConvolutionTerm> terms_;
  Eigen::Index results_ = 0;
  mutable std::vector<Eigen::ArrayXXd> unfolded_;  // [table](offset along a row, offset of rows), created when needed
};

}  // namespace viscoroll::detail
