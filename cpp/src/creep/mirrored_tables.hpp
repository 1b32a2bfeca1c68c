/// @file
/// @brief Displacements of rows of material nodes, around a ring or along a track, under forces that are
/// mirror-symmetric in z.
///
/// Half of such a field is stored: the nodes k = 0 ... of every row. Nodes off the middle plane are multiplied by
/// sqrt(2), so that inner products over the half equal those over the whole field. Components r and phi are even in z,
/// theta is odd.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "influence/table.hpp"

namespace viscoroll::detail {

/// @brief Half of a field: one column for each row of nodes along phi, which contains the nodes of that row, component
/// by component.
using HalfField = Eigen::MatrixXd;

/// @brief Factors of nodes in a `HalfField`: 1 in the middle, sqrt(2) elsewhere.
[[nodiscard]] Eigen::ArrayXd half_weights(Eigen::Index half_nodes);

/// @brief Rows of nodes of some tables.
struct RowShape {
  Eigen::Index components;           ///< 1 for r only, 3 for r, phi and theta
  Eigen::Index half_nodes;           ///< nodes of a row on one side, including the middle
  std::optional<Eigen::Index> ring;  ///< number of rows around the body; none for a track
  Eigen::Index most;                 ///< largest reach of the influence in rows, at most half of a ring
};

/// @brief Influence tables of an elastic coating, folded at the plane of symmetry. They depend on differences along phi
/// only, so that they serve every position of the body.
class MirroredTables {
 public:
  /// @param[in] sum sum of the orders of the coating
  /// @param[in] shape rows of nodes
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  MirroredTables(const TableSum& sum, const RowShape& shape, int threads, Watch& watch);

  /// @brief Tables of several sums with the same reach: influence beyond is below 1e-10 of the sum of their center
  /// values.
  [[nodiscard]] static std::vector<MirroredTables> of_all(const std::vector<std::unique_ptr<const TableSum>>& sums,
                                                          const RowShape& shape, int threads, Watch& watch);
  /// @brief Sum of tables of equal shape and reach, each multiplied by a factor.
  /// @param[in] tables at least one table
  /// @param[in] factors one for each table
  [[nodiscard]] static MirroredTables sum_of(std::span<const MirroredTables> tables, std::span<const double> factors,
                                             const std::function<void()>& checkpoint);

  /// @brief Add another influence of a row.
  /// @param[in] influence on the rows 0, 1, ... reach() ahead, one below the other [m/N]
  void superpose(const HalfField& influence) { ahead_ += influence; }

  [[nodiscard]] Eigen::Index components() const { return shape_.components; }
  [[nodiscard]] Eigen::Index half_nodes() const { return shape_.half_nodes; }
  /// @return number of values in a column of a field
  [[nodiscard]] Eigen::Index height() const { return components() * half_nodes(); }
  /// @return offset along phi beyond which displacements are below 1e-10 of the center value
  [[nodiscard]] Eigen::Index reach() const { return extent_.reach; }

  /// @return whether displacements beyond the reach are negligible; else they are outside the tables
  [[nodiscard]] bool dies_out() const { return extent_.dies_out; }

  /// @return displacement of a node in the middle along r under a unit force on it [m/N]
  [[nodiscard]] double diagonal_compliance() const { return ahead_(0, 0); }

  /// @brief Displacements of some nodes of a window under forces on other nodes.
  /// @param[in] displaced,loaded numbers of nodes in the window, row by row
  /// @return [components * displaced + component][components * loaded + component]
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& displaced,
                                           const std::vector<Eigen::Index>& loaded) const;

  /// @brief Same displacements in one direction.
  /// @param[in] displaced,loaded same as above
  /// @param[in] direction its components at all nodes of the window; ignored for tables of r only
  /// @return [displaced, loaded]
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& displaced,
                                           const std::vector<Eigen::Index>& loaded,
                                           const std::array<HalfField, 3>& direction) const;

  /// @brief Displacements of a window of rows under forces on it.
  /// @param[in] loads one column for each row of the window
  /// @param[in] first,last loaded rows, the last one included
  /// @param[in] checkpoint called every few milliseconds
  [[nodiscard]] HalfField displacement(const HalfField& loads, Eigen::Index first, Eigen::Index last,
                                       const std::function<void()>& checkpoint) const;

  /// @brief Displacements of all rows within reach of a window, which is the middle of the result.
  /// @param[in] loads,first,last,checkpoint same as above
  [[nodiscard]] HalfField displacement_in_reach(const HalfField& loads, Eigen::Index first, Eigen::Index last,
                                                const std::function<void()>& checkpoint) const;

 private:
  struct Extent {
    Eigen::Index reach = 0;
    bool dies_out = true;
  };
  /// @param[in] tables tables of every sum
  [[nodiscard]] static Extent extent_of(const std::vector<std::vector<Table>>& tables, const RowShape& shape);
  MirroredTables(const std::vector<Table>& tables, const RowShape& shape, const Extent& extent, Watch& watch);

  /// Influence of one node on another, by components.
  [[nodiscard]] Eigen::Matrix3d influence(Eigen::Index displaced, Eigen::Index loaded) const;
  /// Position of the columns of the result, which begin `shift` before those of the loads.
  struct Frame {
    Eigen::Index shift;
    Eigen::Index reach;  // largest offset to include
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
