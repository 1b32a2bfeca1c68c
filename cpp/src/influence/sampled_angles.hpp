/// @file
/// @brief Chebyshev points at which waves are summed instead of at all nodes of a mesh, and interpolation to the nodes.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Chebyshev points x = cos(angle) between -1 and 1, and polynomial interpolation from values at these points.
struct ChebyshevNodes {
  Eigen::ArrayXd angle;  ///< angles [rad], ascending

  explicit ChebyshevNodes(int count);

  [[nodiscard]] Eigen::ArrayXd points() const { return angle.cos(); }
  /// @param[in] targets points between -1 and 1 to which values are interpolated
  /// @return interpolation matrix [target, Chebyshev point]
  [[nodiscard]] Eigen::MatrixXd interpolation(const Eigen::ArrayXd& targets) const;
};

/// @brief Nonnegative angular offsets between load and displacement at which waves are summed, and interpolation to the
/// offsets 0, ..., `reach` of a mesh. If polynomials through fewer Chebyshev points represent the waves, the sampled
/// offsets are these points; otherwise they are the offsets of the mesh.
struct SampledOffsets {
  Eigen::ArrayXd sampled;  ///< sampled offsets [rad]
  Eigen::MatrixXd even;    ///< interpolation of even sums [offset, sampled offset]
  Eigen::MatrixXd odd;     ///< interpolation of odd sums [offset, sampled offset]

  /// @param[in] reach largest offset of the mesh [spacings]
  /// @param[in] spacing spacing of the mesh [rad]
  /// @param[in] highest_order highest order of the waves
  SampledOffsets(int reach, double spacing, double highest_order);

  /// @return number of sampled offsets
  [[nodiscard]] static int count(int reach, double spacing, double highest_order);
};

}  // namespace viscoroll::detail
