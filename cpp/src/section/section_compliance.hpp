/// @file
/// @brief Surface compliance of the cross-section of a tread, at one order around the axis.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "section/section_mesh.hpp"

namespace viscoroll::detail {

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
