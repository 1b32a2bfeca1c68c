/// @file
/// @brief Displacements of a ring of material nodes by forces that are mirror images of each other in z.
///
/// Half of such a field is kept: the nodes k = 0 ... of every row, those off the middle plane times sqrt(2), so that
/// inner products over the half are those over the whole. Components r and phi are even in z, theta is odd.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "influence/coating_sum.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Half of a field: a column for each row of nodes along phi; in it the nodes of that row, component by
/// component.
using HalfField = Eigen::MatrixXd;

/// @brief What nodes are multiplied by in a `HalfField`: 1 in the middle, sqrt(2) beside it.
[[nodiscard]] Eigen::ArrayXd half_weights(Eigen::Index half_nodes);

/// @brief Influence tables of an elastic coating, folded at the plane of symmetry. They know differences along phi
/// alone, and so serve every position of the body.
class MirroredTables {
 public:
  /// @param[in] sum orders of the coating
  /// @param[in] components 1 for r alone, 3 for r, phi and theta
  /// @param[in] half_nodes nodes of a row on one side, that in the middle included
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  MirroredTables(const CoatingSum& sum, Eigen::Index components, Eigen::Index half_nodes, int threads, Watch& watch);

  [[nodiscard]] Eigen::Index components() const { return components_; }
  [[nodiscard]] Eigen::Index half_nodes() const { return half_nodes_; }
  /// @return numbers in a column of a field
  [[nodiscard]] Eigen::Index height() const { return components_ * half_nodes_; }
  /// @return rows of nodes around the body
  [[nodiscard]] Eigen::Index ring() const { return ring_; }
  /// @return offset along phi beyond which nothing is displaced, to ten digits of the table's center
  [[nodiscard]] Eigen::Index reach() const { return reach_; }

  /// @brief Influence of a row of nodes on another one.
  /// @param[in] offset of the displaced row from the loaded one, at most the reach in size
  [[nodiscard]] auto block(Eigen::Index offset) const {
    const HalfField& stack = offset >= 0 || components_ == 1 ? ahead_ : behind_;
    return stack.middleRows(std::abs(offset) * height(), height());
  }

  /// @brief Compliance between some nodes of a window, in one direction.
  /// @param[in] nodes numbers in the window, row by row, ascending
  /// @param[in] direction its components at all nodes of the window; not looked at where there is r alone
  /// @return symmetric matrix, whose lower half is set
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& nodes,
                                           const std::array<HalfField, 3>& direction) const;

  /// @brief Displacements along one direction by forces along another one.
  /// @param[in] nodes,displaced,loaded as above; there must be three components
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& nodes,
                                           const std::array<HalfField, 3>& displaced,
                                           const std::array<HalfField, 3>& loaded) const;

  /// @brief Displacements of a window of rows by forces on it.
  /// @param[in] loads a column for each row of the window
  /// @param[in] first,last rows that bear loads, the last one included
  [[nodiscard]] HalfField displacement(const HalfField& loads, Eigen::Index first, Eigen::Index last) const;

  /// @brief Displacements of all rows within reach of a window, which is the middle of the result.
  /// @param[in] loads,first,last as above
  [[nodiscard]] HalfField displacement_in_reach(const HalfField& loads, Eigen::Index first, Eigen::Index last) const;

 private:
  void add(const HalfField& loads, Eigen::Index first, Eigen::Index last, Eigen::Index shift, Eigen::Index reach,
           HalfField& result) const;

  Eigen::Index components_;
  Eigen::Index half_nodes_;
  Eigen::Index ring_;
  Eigen::Index reach_ = 0;
  HalfField ahead_;   // blocks of offsets 0, 1, ... one below the other
  HalfField behind_;  // of offsets 0, -1, ..., where they differ: the transposes
};

}  // namespace viscoroll::detail
