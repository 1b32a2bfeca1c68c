/// @file
/// @brief Some nodes of a window, row by row.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Finds those of a list of nodes that lie in a row, so that products are fed with them and read at them without
/// fields over the whole window.
class NodeRows {
 public:
  /// @param[in] shape window
  /// @param[in] nodes ascending, which outlive this object
  NodeRows(WindowShape shape, const std::vector<Eigen::Index>& nodes)
      : theta_nodes_(shape.theta_nodes), nodes_(nodes), first_(static_cast<std::size_t>(shape.phi_nodes) + 1) {
    for (std::size_t row = 0; row < first_.size(); ++row) {
      const Eigen::Index start = static_cast<Eigen::Index>(row) * theta_nodes_;
      first_[row] = std::ranges::lower_bound(nodes, start) - nodes.begin();
    }
  }

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(nodes_.size()); }

  /// @return the node with a number in the list
  [[nodiscard]] Eigen::Index node(Eigen::Index i) const { return nodes_[static_cast<std::size_t>(i)]; }

  /// @brief Call function(i, k) for the i-th node of the list, in column k, for every one in the row.
  template <class Function>
  void for_row(int row, const Function& function) const {
    const auto place = static_cast<std::size_t>(row);
    const Eigen::Index start = static_cast<Eigen::Index>(row) * theta_nodes_;
    for (Eigen::Index i = first_[place]; i < first_[place + 1]; ++i) function(i, node(i) - start);
  }

 private:
  Eigen::Index theta_nodes_;
  const std::vector<Eigen::Index>& nodes_;
  std::vector<Eigen::Index> first_;  // number in the list of the first node of every row, and of the end
};

}  // namespace viscoroll::detail
