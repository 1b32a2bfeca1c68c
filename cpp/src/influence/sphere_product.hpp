/// @file
/// @brief Products on the exact sphere, where the influence depends on theta of both nodes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "base/parallel.hpp"
#include "influence/fft.hpp"
#include "influence/sphere_sum.hpp"
#include "influence/table_product.hpp"

namespace viscoroll::detail {

/// @brief Displacements, or powers, of the nodes of a window due to forces on them.
class SphereProduct {
 public:
  virtual ~SphereProduct() = default;

  /// @param[in] loads one column per component and one row per node
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return displacements or powers in the same layout
  [[nodiscard]] virtual Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const = 0;

  /// @return approximate number of floating-point operations of a product
  [[nodiscard]] virtual double operations() const = 0;
};

/// @brief Product by vector spherical harmonics: forces are summed to the amplitude of each order and degree, and these
/// to displacements. The part above the summed degrees uses transforms along both angles.
class FactoredSphereProduct : public SphereProduct {
 public:
  /// @param[in] shape window, within the reach of the influence
  /// @param[in] first_theta first column of the window, counted from the equator
  /// @param[in] influence influence between these and possibly other nodes
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  FactoredSphereProduct(WindowShape shape, int first_theta, std::shared_ptr<const SphereInfluence> influence,
                        int threads, Watch& watch);

  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const override;
  [[nodiscard]] double operations() const override;

 private:
  [[nodiscard]] Eigen::MatrixXd folded(const Eigen::ArrayXXd& loads) const;
  [[nodiscard]] Eigen::ArrayXXd unfolded(const Eigen::MatrixXd& sides) const;
  void respond(const SphericalOrder& order, Eigen::Ref<Eigen::MatrixXd> amplitudes) const;
  void add_local(const Eigen::ArrayXXd& loads, Eigen::ArrayXXd& result, int threads, Watch& watch) const;

  WindowShape shape_;
  int first_theta_;
  Eigen::Index half_;  // number of thetas on one side, including the equator
  Eigen::Index components_;
  std::shared_ptr<const SphereInfluence> influence_;
  Eigen::MatrixXd waves_;               // [phi, 2 m] is the cosine and [phi, 2 m + 1] minus the sine of m phi
  std::vector<Eigen::ArrayXd> metric_;  // [power], factor of each node of the window
  std::optional<Convolution> local_;    // fields power * components + component
};

/// @brief Create the product that takes fewer operations: `JointSphereProduct`, which suits few nodes, or
/// `FactoredSphereProduct`. Parameters same as in these.
[[nodiscard]] std::unique_ptr<const SphereProduct> make_sphere_product(WindowShape shape, int first_theta,
                                                                       std::shared_ptr<const SphereInfluence> influence,
                                                                       int threads, Watch& watch);

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
