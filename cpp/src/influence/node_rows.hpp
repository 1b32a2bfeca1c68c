/// @file
/// @brief Selected nodes of a window, row by row.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief List of nodes with access by row, so that products are fed with and read at these nodes without fields over
/// the whole window. Nodes may also represent their mirror images across the middle column.
class NodeRows {
 public:
  /// @param[in] shape window; its number of columns is odd if mirrored
  /// @param[in] nodes node numbers, ascending
  /// @param[in] mirrored whether the nodes include their mirror images, at which fields are equal; only those from the
  /// middle column on are kept
  NodeRows(WindowShape shape, const std::vector<Eigen::Index>& nodes, bool mirrored = false)
      : theta_nodes_(shape.theta_nodes), mirrored_(mirrored), first_column_(mirrored ? shape.theta_nodes / 2 : 0) {
    nodes_.reserve(nodes.size());
    first_.reserve(static_cast<std::size_t>(shape.phi_nodes) + 1);
    auto next = nodes.begin();
    for (int row = 0; row < shape.phi_nodes; ++row) {
      first_.push_back(count());
      next = std::lower_bound(next, nodes.end(), start_of(row));
      const auto end = std::lower_bound(next, nodes.end(), (row + 1) * theta_nodes_);
      nodes_.insert(nodes_.end(), next, end);
      next = end;
    }
    first_.push_back(count());
  }

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(nodes_.size()); }
  [[nodiscard]] bool mirrored() const { return mirrored_; }
  /// @return column from which `for_row` counts
  [[nodiscard]] Eigen::Index first_column() const { return first_column_; }
  [[nodiscard]] int rows() const { return static_cast<int>(first_.size()) - 1; }

  /// @return number of the i-th node of the list
  [[nodiscard]] Eigen::Index node(Eigen::Index i) const { return nodes_[static_cast<std::size_t>(i)]; }

  /// @brief Call function(i, k) for every node of the list in a row; the i-th node lies in column first_column() + k.
  /// If mirrored, the image of the node is node(i) - 2 k.
  template <class Function>
  void for_row(int row, const Function& function) const {
    const auto place = static_cast<std::size_t>(row);
    const Eigen::Index start = start_of(row);
    for (Eigen::Index i = first_[place]; i < first_[place + 1]; ++i) function(i, node(i) - start);
  }

 private:
  [[nodiscard]] Eigen::Index start_of(int row) const { return row * theta_nodes_ + first_column_; }

  Eigen::Index theta_nodes_;
  bool mirrored_;
  Eigen::Index first_column_;
  std::vector<Eigen::Index> nodes_;
  std::vector<Eigen::Index> first_;  // index in the list of the first node of every row, and of the end
};

}  // namespace viscoroll::detail
