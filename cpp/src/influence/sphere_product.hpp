/// @file
/// @brief Products with influence that depends on both thetas: of low degrees by transforms along phi and matrices
/// along theta, of the others by transforms along both.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "influence/convolution.hpp"
#include "influence/fft.hpp"
#include "influence/spectral_product.hpp"
#include "influence/sphere_sum.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Displacements, or powers, of the nodes of a window by forces on them.
class SphereProduct {
 public:
  /// @param[in] shape window, no wider than the influence reaches
  /// @param[in] first_theta number of its first column among the nodes of the influence
  /// @param[in] influence of these and other nodes
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  SphereProduct(WindowShape shape, int first_theta, const SphereInfluence& influence, int threads, Watch& watch);

  /// @param[in] loads a column for each component, a row for each node
  /// @return the same of what they cause
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const;

  /// @return floating-point operations of it, roughly
  [[nodiscard]] double operations() const;

 private:
  void add_local(const Eigen::ArrayXXd& loads, Eigen::ArrayXXd& result, int threads, Watch& watch) const;

  WindowShape shape_;
  Eigen::Index components_;
  Eigen::MatrixXd displaced_;  // [theta of the window, theta of the spectrum]
  Eigen::MatrixXd loaded_;
  int period_;  // along phi, so long that images do not meet
  RealFft fft_;
  std::vector<Eigen::MatrixXcd> spectrum_;  // [frequency], rows and columns component * thetas + theta
  std::vector<Eigen::ArrayXd> metric_;      // [power] what each node of the window has of it
  std::optional<Convolution> local_;        // fields power * components + component
};

/// @brief The same, with all of the influence in one table where that takes fewer operations, as it does between few
/// nodes.
[[nodiscard]] SphereProduct make_sphere_product(WindowShape shape, int first_theta, const SphereInfluence& influence,
                                                int threads, Watch& watch);

}  // namespace viscoroll::detail
