/// @file
/// @brief Displacements of rows of material nodes, around a ring or along a track, by forces that are mirror images of
/// each other in z.
///
/// Half of such a field is kept: the nodes k = 0 ... of every row, those off the middle plane times sqrt(2), so that
/// inner products over the half are those over the whole. Components r and phi are even in z, theta is odd.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "influence/table_sum.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Half of a field: a column for each row of nodes along phi; in it the nodes of that row, component by
/// component.
using HalfField = Eigen::MatrixXd;

/// @brief What nodes are multiplied by in a `HalfField`: 1 in the middle, sqrt(2) beside it.
[[nodiscard]] Eigen::ArrayXd half_weights(Eigen::Index half_nodes);

/// @brief Rows of nodes that tables are to serve.
struct RowShape {
  Eigen::Index components;           ///< 1 for r alone, 3 for r, phi and theta
  Eigen::Index half_nodes;           ///< nodes of a row on one side, that in the middle included
  std::optional<Eigen::Index> ring;  ///< rows around the body; none along a track
  Eigen::Index most;                 ///< rows that influence may reach, at most half of a ring
};

/// @brief Influence tables of an elastic coating, folded at the plane of symmetry. They know differences along phi
/// alone, and so serve every position of the body.
class MirroredTables {
 public:
  /// @param[in] sum orders of the coating
  /// @param[in] shape of the rows
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  MirroredTables(const TableSum& sum, const RowShape& shape, int threads, Watch& watch);

  /// @brief Those of several sums, which reach equally far: to ten digits of the center of them all.
  [[nodiscard]] static std::vector<MirroredTables> of_all(const std::vector<std::unique_ptr<const TableSum>>& sums,
                                                          const RowShape& shape, int threads, Watch& watch);
  /// @brief The sum of tables of one shape and reach, each times a factor.
  /// @param[in] tables at least one
  /// @param[in] factors one for each
  [[nodiscard]] static MirroredTables sum_of(std::span<const MirroredTables> tables, std::span<const double> factors,
                                             const std::function<void()>& checkpoint);

  /// @brief Add what else a row displaces.
  /// @param[in] influence on the rows 0, 1, ... reach() ahead, one below the other [m/N]
  void superpose(const HalfField& influence) { ahead_ += influence; }

  [[nodiscard]] Eigen::Index components() const { return shape_.components; }
  [[nodiscard]] Eigen::Index half_nodes() const { return shape_.half_nodes; }
  /// @return numbers in a column of a field
  [[nodiscard]] Eigen::Index height() const { return components() * half_nodes(); }
  /// @return offset along phi beyond which nothing is displaced, to ten digits of the table's center
  [[nodiscard]] Eigen::Index reach() const { return extent_.reach; }

  /// @return whether what lies beyond is not displaced, rather than out of the tables
  [[nodiscard]] bool dies_out() const { return extent_.dies_out; }

  /// @return displacement of a node in the middle by a unit force on it, along r [m/N]
  [[nodiscard]] double own_compliance() const { return ahead_(0, 0); }

  /// @brief Displacements of some nodes of a window by forces on others of it.
  /// @param[in] displaced,loaded numbers in the window, row by row
  /// @return [components * displaced + component][components * loaded + component]
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& displaced,
                                           const std::vector<Eigen::Index>& loaded) const;

  /// @brief The same in one direction.
  /// @param[in] displaced,loaded as above
  /// @param[in] direction its components at all nodes of the window; not looked at where there is r alone
  /// @return [displaced, loaded]
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& displaced,
                                           const std::vector<Eigen::Index>& loaded,
                                           const std::array<HalfField, 3>& direction) const;

  /// @brief Displacements of a window of rows by forces on it.
  /// @param[in] loads a column for each row of the window
  /// @param[in] first,last rows that bear loads, the last one included
  /// @param[in] checkpoint called every few milliseconds
  [[nodiscard]] HalfField displacement(const HalfField& loads, Eigen::Index first, Eigen::Index last,
                                       const std::function<void()>& checkpoint) const;

  /// @brief Displacements of all rows within reach of a window, which is the middle of the result.
  /// @param[in] loads,first,last,checkpoint as above
  [[nodiscard]] HalfField displacement_in_reach(const HalfField& loads, Eigen::Index first, Eigen::Index last,
                                                const std::function<void()>& checkpoint) const;

 private:
  struct Extent {
    Eigen::Index reach = 0;
    bool dies_out = true;
  };
  /// @param[in] tables of every sum
  [[nodiscard]] static Extent extent_of(const std::vector<std::vector<Table>>& tables, const RowShape& shape);
  MirroredTables(const std::vector<Table>& tables, const RowShape& shape, const Extent& extent, Watch& watch);

  /// The influence of one node on another, by components.
  [[nodiscard]] Eigen::Matrix3d influence(Eigen::Index displaced, Eigen::Index loaded) const;
  /// Columns of the result begin so many before those of the loads.
  struct Frame {
    Eigen::Index shift;
    Eigen::Index reach;  // to which the influence is wanted
  };
  [[nodiscard]] HalfField displaced(const HalfField& loads, Eigen::Index first, Eigen::Index last, const Frame& frame,
                                    const std::function<void()>& checkpoint) const;
  /// Some of the offsets along phi within reach.
  struct Offsets {
    Eigen::Index first;
    Eigen::Index count;
  };
  void add(const HalfField& loads, Eigen::Index first, Eigen::Index last, const Frame& frame, const Offsets& offsets,
           HalfField& result) const;

  RowShape shape_;
  Extent extent_;
  HalfField ahead_;  // influence of a row on those 0, 1, ... rows ahead, one below the other; behind, phi is reversed
};

}  // namespace viscoroll::detail
