/// @file
/// @brief Product on the exact sphere with one matrix of all influences per frequency.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "influence/fft.hpp"
#include "influence/sphere_product.hpp"

namespace viscoroll::detail {

/// @brief Product by transforms along phi and, at each frequency, a matrix over theta of the nodes.
class JointSphereProduct : public SphereProduct {
 public:
  /// Parameters same as in `FactoredSphereProduct`.
  JointSphereProduct(WindowShape shape, int first_theta, const SphereInfluence& influence, int threads, Watch& watch);

  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const override;
  [[nodiscard]] double operations() const override;

  /// @return number of operations for a window
  [[nodiscard]] static double operations(WindowShape shape, std::size_t components);

 private:
  WindowShape shape_;
  Eigen::Index components_;
  int period_;  // along phi, long enough to keep images apart
  RealFft fft_;
  std::vector<Eigen::MatrixXcd> spectrum_;  // [frequency], rows and columns component * thetas + theta
};

}  // namespace viscoroll::detail
