/// @file
/// @brief Half of a tread's section, cut along the axis, as a lattice of elements: from the middle of the tread to its
/// face, and beyond it where there is none.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "viscoroll/wheel.hpp"

namespace viscoroll::detail {

/// @brief What becomes of a tread at half its width.
enum class SectionEnd {
  face,     ///< it ends
  endless,  ///< it goes on, crowned as it is within the width, until nothing of its end is felt
};

/// @brief How finely a section is cut, relative to the thickness of the tread or, if that is less, its width.
struct SectionFineness {
  double finest = 1.0 / 16.0;  ///< of elements at the surface, at the face and at the hub
  double growth = 1.0;         ///< of their size by the distance from there
  double largest = 1.0 / 2.0;  ///< of any within the width

  /// Of any across, of the width, where that is more: what changes from the middle of a wide tread to its faces does so
  /// over its width. With four times as many, torques of wheels 40 and 100 thicknesses wide, crowned by up to a
  /// thickness, change by 2e-5, largest pressures by 2e-4.
  double widest = 1.0 / 32.0;
};

/// @brief Elements with nine nodes each. Lines of nodes lead from the hub to the surface, two for each column of
/// elements and one at the end; the first one is the middle of the tread.
class SectionMesh {
 public:
  /// @param[in] wheel at least one layer
  /// @param[in] end beyond half the width
  /// @param[in] fineness of the elements
  SectionMesh(const CoatedWheel& wheel, SectionEnd end, const SectionFineness& fineness = {});

  [[nodiscard]] std::size_t lines() const { return static_cast<std::size_t>(z_.size()); }
  [[nodiscard]] std::size_t rows() const { return 2 * layer_of_row_.size() + 1; }
  /// @return number of lines whose ends may bear loads: those within the width
  [[nodiscard]] std::size_t loaded_lines() const { return loaded_lines_; }
  /// @return where all lines are, from the middle outwards [m]
  [[nodiscard]] const Eigen::ArrayXd& z() const { return z_; }
  /// @return radius of a node [m]
  [[nodiscard]] double radius(std::size_t line, std::size_t row) const {
    return r_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(line));
  }
  /// @return how steeply the surface falls to the side at the end of a line
  [[nodiscard]] double slope(std::size_t line) const { return slope_[static_cast<Eigen::Index>(line)]; }
  [[nodiscard]] std::size_t node(std::size_t line, std::size_t row) const { return line * rows() + row; }

  [[nodiscard]] std::size_t columns() const { return (lines() - 1) / 2; }
  [[nodiscard]] std::size_t element_rows() const { return layer_of_row_.size(); }
  /// @return which layer a row of elements belongs to
  [[nodiscard]] std::size_t layer(std::size_t element_row) const { return layer_of_row_[element_row]; }

 private:
  Eigen::ArrayXd z_;
  Eigen::ArrayXXd r_;                      // [row, line]
  Eigen::ArrayXd slope_;                   // [line]
  std::vector<std::size_t> layer_of_row_;  // from the hub outwards
  std::size_t loaded_lines_ = 0;
};

}  // namespace viscoroll::detail
