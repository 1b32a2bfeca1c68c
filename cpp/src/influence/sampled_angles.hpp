/// @file
/// @brief Few angles that waves are summed at, and polynomials from there to the nodes of a mesh.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Places between -1 and 1, and what polynomials through values there are elsewhere.
struct ChebyshevNodes {
  Eigen::ArrayXd angle;

  explicit ChebyshevNodes(int count);

  [[nodiscard]] Eigen::ArrayXd places() const { return angle.cos(); }
  /// @return matrix [place, node]
  [[nodiscard]] Eigen::MatrixXd interpolation(const Eigen::ArrayXd& places) const;
};

/// @brief Offsets, none of them negative, that waves are summed at, and what even and odd sums are at those of a mesh,
/// [offset, sampled]: themselves, or polynomials where fewer will do.
struct SampledOffsets {
  Eigen::ArrayXd sampled;  ///< [rad]
  Eigen::MatrixXd even;
  Eigen::MatrixXd odd;

  /// @param[in] reach largest offset of the mesh [spacings]
  /// @param[in] spacing of the mesh [rad]
  /// @param[in] highest_order of the waves
  SampledOffsets(int reach, double spacing, double highest_order);

  /// @return how many there are
  [[nodiscard]] static int count(int reach, double spacing, double highest_order);
};

}  // namespace viscoroll::detail
