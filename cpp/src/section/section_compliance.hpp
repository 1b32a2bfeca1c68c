/// @file
/// @brief Finite elements of half of the cross-section of a tread at one order around the axis: their mesh, from the
/// middle of the tread to its face, or beyond half the width if the tread is unbounded, their stiffness matrices, and
/// the compliance of the surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <span>
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

/// @brief Shear modulus and Lame's first parameter, in a common unit of stress.
template <class Scalar>
struct SectionMedium {
  Scalar shear;
  Scalar lame;
};

/// @brief Parts of the displacements. In the even part U and V are even about the middle of the tread and W is odd; in
/// the odd part it is the reverse.
enum Parity : std::size_t { kEvenPart, kOddPart };

/// @brief Parts for arbitrary loads. Loads that are symmetric about the middle cause even displacements only.
inline constexpr std::array kBothParts{kEvenPart, kOddPart};

/// @brief Compliance of the section at the surface nodes that can be loaded: the inverse of its condensed stiffness.
///
/// The unknowns of these nodes come last in the factorization L D L^T of the stiffness matrix. Their condensed
/// stiffness is therefore the product of the trailing blocks of L, D and L^T, without a solve for the other unknowns.
/// Loads and displacements at the surface are along its normal, phi and its tangent. With the slope s of the surface
/// these directions are (1, s) in (r, z), 1 in phi, and (-s, 1) in (r, z). Pressure acts along the normal, and a
/// displacement along the crown does not change the gap.
class SectionCompliance {
 public:
  template <class Scalar>
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param[in] mesh half of the section
  /// @param[in] tangential whether there are tangential loads besides normal ones
  SectionCompliance(SectionMesh mesh, bool tangential);

  [[nodiscard]] const SectionMesh& mesh() const { return mesh_; }

  /// @brief Compliance at one order.
  /// @param[in] m order, >= 0, not necessarily a whole number
  /// @param[in] layers material of each layer, from the hub outwards
  /// @param[in] parts requested parts
  /// @return for each part, displacements [m] under unit loads; a load acts on half of the section, per radian
  /// [1/(unit of stress)/m]. Rows and columns are component (U, V, W) * `loaded_lines()` + line. Entries are zero where
  /// symmetry fixes the middle of the tread.
  template <class Scalar>
  [[nodiscard]] std::array<Matrix<Scalar>, 2> at(double m, const std::vector<SectionMedium<Scalar>>& layers,
                                                 std::span<const Parity> parts = kBothParts) const;

 private:
  /// Order in which the unknowns are eliminated.
  struct Elimination {
    std::vector<int> position;  // [3 * node + component] position in this order; < 0 for a fixed displacement
    int eliminated = 0;         // number of eliminated unknowns, which precede those of the loaded surface
    std::vector<int> loaded;    // [position - eliminated] row of the result
  };
  [[nodiscard]] Elimination elimination(Parity part) const;
  /// Replace the unknowns along r and z at the surface of a column's last element by those along normal and tangent.
  void rotate_surface_unknowns(std::size_t column, ElementStiffness& stiffness) const;
  /// Length of the direction vector of each row of the result.
  [[nodiscard]] Eigen::VectorXd lengths() const;

  SectionMesh mesh_;
  std::size_t components_;
  std::vector<std::array<std::size_t, kElementNodes>> nodes_;  // [element]
  std::vector<ElementStiffness> elements_;
  std::array<Elimination, 2> eliminations_;
};

}  // namespace viscoroll::detail
