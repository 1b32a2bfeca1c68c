/// @file
/// @brief Few angles at which waves are summed, and interpolation from these to the nodes of a mesh.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Chebyshev points between -1 and 1, and polynomial interpolation from values at these points.
struct ChebyshevNodes {
  Eigen::ArrayXd angle;

  explicit ChebyshevNodes(int count);

  [[nodiscard]] Eigen::ArrayXd places() const { return angle.cos(); }
  /// @return matrix [place, node]
  [[nodiscard]] Eigen::MatrixXd interpolation(const Eigen::ArrayXd& places) const;
};

/// @brief Nonnegative offsets at which waves are summed, and matrices [offset, sampled] that give even and odd sums at
/// the offsets of a mesh. The sampled offsets are those of the mesh, or fewer if polynomials suffice.
struct SampledOffsets {
  Eigen::ArrayXd sampled;  ///< sampled offsets [rad]
  Eigen::MatrixXd even;
  Eigen::MatrixXd odd;

  /// @param[in] reach largest offset of the mesh [spacings]
  /// @param[in] spacing spacing of the mesh [rad]
  /// @param[in] highest_order highest order of the waves
  SampledOffsets(int reach, double spacing, double highest_order);

  /// @return number of sampled offsets
  [[nodiscard]] static int count(int reach, double spacing, double highest_order);
};

}  // namespace viscoroll::detail
