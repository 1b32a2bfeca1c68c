/// @file
/// @brief Influence tables applied on a window node by node, where few nodes are loaded.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/convolution.hpp"

namespace viscoroll::detail {

/// @brief The products of a `Convolution` by sums over the nodes that are loaded: of small contacts they take less
/// time, and no spectra. An object serves one product at a time.
class TableProduct {
 public:
  using Tables = std::shared_ptr<const std::vector<Table>>;

  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables of which those that occur in terms are used
  /// @param[in] terms summands
  TableProduct(WindowShape shape, Tables tables, std::vector<ConvolutionTerm> terms);

  /// @brief A product from rows to rows, see `SpectralProduct`, where it takes less time than transforms.
  /// @return whether it was taken; if not, nothing was handed to `take`
  [[nodiscard]] bool apply(std::size_t fields, const SpectralProduct::Fill& fill,
                           const SpectralProduct::Take& take) const;

  [[nodiscard]] const std::vector<ConvolutionTerm>& terms() const { return terms_; }

  /// @param[in] table number of a table
  /// @param[in] displaced,loaded nodes of the window
  /// @return its values, a row for each of the former and a column for each of the latter
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
  mutable std::vector<Eigen::ArrayXXd> unfolded_;  // [table](offset along a row, offset of rows), as they are needed
};

}  // namespace viscoroll::detail
