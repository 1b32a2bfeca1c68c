/// @file
/// @brief Finite elements of half of a tread's section: their mesh, from the middle of the tread to its face, or beyond
/// half the width if the tread is unbounded, and their stiffness matrices.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "viscoroll/wheel.hpp"

namespace viscoroll::detail {

/// @brief End of a tread at half its width.
enum class SectionEnd {
  face,       ///< the tread ends
  unbounded,  ///< the tread continues with the same crown, until the effect of its end is negligible
};

/// @brief Sizes of the elements, relative to the thickness of the tread or its width, whichever is less.
struct SectionFineness {
  double finest = 1.0 / 16.0;  ///< size of elements at the surface, the face and the hub
  double growth = 1.0;         ///< growth of the size per distance from there
  double largest = 1.0 / 2.0;  ///< largest size within the width, relative to the thickness

  /// Largest size across, relative to the width, if this exceeds `largest`. Changes from the middle of a wide tread to
  /// its faces extend over the width. With four times as many elements across, torques of wheels 40 and 100 thicknesses
  /// wide, crowned by up to a thickness, change by 2e-5, largest pressures by 2e-4.
  double widest = 1.0 / 32.0;
};

/// @brief Mesh of elements with nine nodes each.
///
/// Lines of nodes lead from the hub to the surface, two for each column of elements and one at the end. The first line
/// is in the middle of the tread.
class SectionMesh {
 public:
  /// @param[in] wheel wheel with at least one layer
  /// @param[in] end end of the tread at half the width
  /// @param[in] fineness sizes of the elements
  SectionMesh(const CoatedWheel& wheel, SectionEnd end, const SectionFineness& fineness = {});

  [[nodiscard]] std::size_t lines() const { return static_cast<std::size_t>(z_.size()); }
  [[nodiscard]] std::size_t rows() const { return 2 * layer_of_row_.size() + 1; }
  /// @return number of lines whose ends can be loaded: those within the width
  [[nodiscard]] std::size_t loaded_lines() const { return loaded_lines_; }
  /// @return axial positions of all lines, from the middle outwards [m]
  [[nodiscard]] const Eigen::ArrayXd& z() const { return z_; }
  /// @return radius of a node [m]
  [[nodiscard]] double radius(std::size_t line, std::size_t row) const {
    return r_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(line));
  }
  /// @return slope of the surface at the end of a line, positive if the radius decreases outwards
  [[nodiscard]] double slope(std::size_t line) const { return slope_[static_cast<Eigen::Index>(line)]; }
  [[nodiscard]] std::size_t node(std::size_t line, std::size_t row) const { return line * rows() + row; }

  [[nodiscard]] std::size_t columns() const { return (lines() - 1) / 2; }
  [[nodiscard]] std::size_t element_rows() const { return layer_of_row_.size(); }
  /// @return index of the layer that contains a row of elements
  [[nodiscard]] std::size_t layer(std::size_t element_row) const { return layer_of_row_[element_row]; }

 private:
  Eigen::ArrayXd z_;
  Eigen::ArrayXXd r_;                      // [row, line]
  Eigen::ArrayXd slope_;                   // [line]
  std::vector<std::size_t> layer_of_row_;  // from the hub outwards
  std::size_t loaded_lines_ = 0;
};

constexpr Eigen::Index kElementNodes = 9;
constexpr Eigen::Index kElementUnknowns = 3 * kElementNodes;  ///< U, V and W of the first node, then of the second, ...

using ElementMatrix = Eigen::Matrix<double, kElementUnknowns, kElementUnknowns>;

/// @brief A matrix with one term for each power of m: 0, 1 and 2.
using PowersOfOrder = std::array<ElementMatrix, 3>;

/// @brief Stiffness of an element per radian [m]: mu * shear + lambda * volumetric.
struct ElementStiffness {
  PowersOfOrder shear;       ///< from the square of the strain tensor
  PowersOfOrder volumetric;  ///< from the square of the volumetric strain
};

/// @brief Stiffness matrices of an element.
/// @param[in] r,z coordinates of the nodes [m], 3 along the first coordinate (z) for each of 3 along the second (r)
/// @return the matrices
[[nodiscard]] ElementStiffness element_stiffness(const std::array<double, kElementNodes>& r,
                                                 const std::array<double, kElementNodes>& z);

/// @return value of a matrix at an order m
[[nodiscard]] ElementMatrix at_order(const PowersOfOrder& powers, double m);

/// @brief Quadratic shape functions of an edge.
/// @param[in] x coordinate on the edge, in [-1, 1]
/// @return shape functions of the first end, the middle and the other end
[[nodiscard]] std::array<double, 3> quadratic_shares(double x);

}  // namespace viscoroll::detail
