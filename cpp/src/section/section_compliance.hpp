/// @file
/// @brief What loads on a tread's section do to its surface, at one order around the axis.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "section/section_element.hpp"
#include "section/section_mesh.hpp"

namespace viscoroll::detail {

/// @brief Shear modulus and Lame's first parameter, in any unit of stress.
template <class Scalar>
struct SectionMedium {
  Scalar shear;
  Scalar lame;
};

/// @brief Which part of displacements: that with U and V even about the middle of the tread, and W odd, or the other.
enum Parity : std::size_t { kEvenPart, kOddPart };

/// @brief Of all loads; those that are mirror images about the middle displace the even part alone.
inline constexpr std::array kBothParts{kEvenPart, kOddPart};

/// @brief The section's stiffness condensed onto the lines of nodes that may bear loads. Eliminating the surface last
/// leaves its own stiffness as the last corner of the factors: nothing is solved for.
///
/// Loads and displacements at the surface are along its normal, phi and its tangent, (1, s), 1 and (-s, 1) where it
/// falls by s: what slides along a crown does not come nearer to what it rolls on, and pressure acts along the normal.
class SectionCompliance {
 public:
  template <class Scalar>
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param[in] mesh half of the section
  /// @param[in] tangential whether loads along phi and z occur, or those along r alone
  SectionCompliance(SectionMesh mesh, bool tangential);

  [[nodiscard]] const SectionMesh& mesh() const { return mesh_; }

  /// @param[in] m order, >= 0, not necessarily whole
  /// @param[in] layers what they are made of, from the hub outwards
  /// @param[in] parts that are asked for
  /// @return [part] displacements per load on half of the section, per radian: rows and columns component (U, V, W) *
  /// `loaded_lines()` + line, zero where the middle of the tread cannot move [1/(unit of stress)/m]
  template <class Scalar>
  [[nodiscard]] std::array<Matrix<Scalar>, 2> at(double m, const std::vector<SectionMedium<Scalar>>& layers,
                                                 std::span<const Parity> parts = kBothParts) const;

 private:
  /// Places of the unknowns in the order in which they are eliminated.
  struct Elimination {
    std::vector<int> place;   // [3 * node + component], < 0 where nothing moves
    int within = 0;           // number of those that are eliminated
    std::vector<int> loaded;  // [place - within], row of the result
  };
  [[nodiscard]] Elimination elimination(Parity part) const;
  /// Put unknowns along normal and tangent in place of those along r and z at the surface of a column's last element.
  void turn_surface(std::size_t column, ElementStiffness& stiffness) const;
  /// [row of the result] length of the direction that it is along.
  [[nodiscard]] Eigen::VectorXd lengths() const;

  SectionMesh mesh_;
  std::size_t components_;
  std::vector<std::array<std::size_t, kElementNodes>> nodes_;  // [element]
  std::vector<ElementStiffness> elements_;
  std::array<Elimination, 2> parts_;
};

}  // namespace viscoroll::detail
