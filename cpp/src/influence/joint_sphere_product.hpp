/// @file
/// @brief Products with all influence between the nodes of a window in one table.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "influence/fft.hpp"
#include "influence/sphere_product.hpp"

namespace viscoroll::detail {

/// @brief By transforms along phi and a matrix over the thetas for each frequency.
class JointSphereProduct : public SphereProduct {
 public:
  /// Parameters as for `FactoredSphereProduct`.
  JointSphereProduct(WindowShape shape, int first_theta, const SphereInfluence& influence, int threads, Watch& watch);

  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const override;
  [[nodiscard]] double operations() const override;

  /// @return what they would be for a window
  [[nodiscard]] static double operations(WindowShape shape, std::size_t components);

 private:
  WindowShape shape_;
  Eigen::Index components_;
  int period_;  // along phi, so long that images do not meet
  RealFft fft_;
  std::vector<Eigen::MatrixXcd> spectrum_;  // [frequency], rows and columns component * thetas + theta
};

}  // namespace viscoroll::detail
