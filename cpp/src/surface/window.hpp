/// @file
/// @brief Rectangles of a grid of nodes, on any surface.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Consecutive nodes in one direction, counted from the lowest point.
struct NodeRange {
  int first;
  int last;  ///< last node, inclusive

  [[nodiscard]] int count() const { return last - first + 1; }
  /// @return range of every other node whose fine neighbors on both sides are in this range
  [[nodiscard]] NodeRange coarsened() const { return {-((-first - 1) / 2), (last - 1) / 2}; }
  friend bool operator==(const NodeRange&, const NodeRange&) = default;
};

/// @brief Rectangle of nodes, numbered row by row. Material crosses it from row to row; upstream rows come first.
struct Window {
  NodeRange phi;
  NodeRange theta;

  [[nodiscard]] WindowShape shape() const { return {phi.count(), theta.count()}; }
  /// @return whether it is a single row of nodes along the path: line contact, which has no edges sideways
  [[nodiscard]] bool is_line() const { return theta.first == 0 && theta.last == 0; }
  /// @return number of node (i, k) in this window
  [[nodiscard]] Eigen::Index number_of(int i, int k) const {
    return static_cast<Eigen::Index>(i - phi.first) * theta.count() + k - theta.first;
  }
  /// @return number in this window of the node with number `node` in another window inside this one
  [[nodiscard]] Eigen::Index number_of(const Window& other, Eigen::Index node) const {
    return number_of(other.phi.first + static_cast<int>(node / other.theta.count()),
                     other.theta.first + static_cast<int>(node % other.theta.count()));
  }
  /// @return window of every other node
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
