/// @file
/// @brief Products with influence tables that depend on both thetas: transforms along phi, matrices along theta.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/fft.hpp"
#include "influence/spectral_product.hpp"
#include "influence/sphere_sum.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Displacements, or powers, of the nodes of a window by forces on them.
class SphereProduct {
 public:
  /// @param[in] shape window, no wider than the tables reach
  /// @param[in] first_theta number of its first column in the tables
  /// @param[in] tables one for r by r, or nine [3 P + Q]
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  SphereProduct(WindowShape shape, int first_theta, const std::vector<SphereTable>& tables, int threads, Watch& watch);

  /// @param[in] loads a column for each component, a row for each node
  /// @return the same of what they cause
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const;

  [[nodiscard]] int components() const { return components_; }

 private:
  WindowShape shape_;
  int components_;
  int period_;  // along phi, so long that images do not meet
  RealFft fft_;
  std::vector<Eigen::MatrixXcd> spectrum_;  // [frequency], rows and columns component * theta_nodes + k
};

}  // namespace viscoroll::detail
