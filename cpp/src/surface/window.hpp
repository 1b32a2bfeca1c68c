/// @file
/// @brief Rectangles of a grid of nodes, whatever surface they lie on.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Consecutive nodes along a direction, counted from the lowest point.
struct NodeRange {
  int first;
  int last;  ///< the last one itself

  [[nodiscard]] int count() const { return last - first + 1; }
  /// @return the range of every other node from which both fine neighbors of each node can be reached
  [[nodiscard]] NodeRange coarsened() const { return {-((-first - 1) / 2), (last - 1) / 2}; }
  friend bool operator==(const NodeRange&, const NodeRange&) = default;
};

/// @brief A rectangle of nodes, numbered row by row: material crosses it from row to row, upstream rows first.
struct Window {
  NodeRange phi;
  NodeRange theta;

  [[nodiscard]] WindowShape shape() const { return {phi.count(), theta.count()}; }
  /// @return whether it is a single row of nodes: line contact, which has no edges sideways
  [[nodiscard]] bool is_line() const { return theta.first == 0 && theta.last == 0; }
  /// @return the number, in this window, of node (i, k)
  [[nodiscard]] Eigen::Index number_of(int i, int k) const {
    return static_cast<Eigen::Index>(i - phi.first) * theta.count() + k - theta.first;
  }
  /// @return the number, in this window, of the node of another one that has number `node` there; inside this window
  [[nodiscard]] Eigen::Index number_of(const Window& other, Eigen::Index node) const {
    return number_of(other.phi.first + static_cast<int>(node / other.theta.count()),
                     other.theta.first + static_cast<int>(node % other.theta.count()));
  }
  /// @return the window of every other node
  [[nodiscard]] Window coarsened() const { return {phi.coarsened(), theta.coarsened()}; }
  friend bool operator==(const Window&, const Window&) = default;
};

/// @brief Call function(node, number in `outer`) for every node of a window inside another one.
template <class Function>
void for_nodes_within(const Window& outer, const Window& inner, const Function& function) {
  Eigen::Index node = 0;
  for (int i = inner.phi.first; i <= inner.phi.last; ++i) {
    for (int k = inner.theta.first; k <= inner.theta.last; ++k) function(node++, outer.number_of(i, k));
  }
}

}  // namespace viscoroll::detail
