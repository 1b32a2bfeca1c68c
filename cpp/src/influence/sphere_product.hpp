/// @file
/// @brief Products with influence that depends on both thetas.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "influence/convolution.hpp"
#include "influence/sphere_sum.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Displacements, or powers, of the nodes of a window by forces on them.
class SphereProduct {
 public:
  virtual ~SphereProduct() = default;

  /// @param[in] loads a column for each component, a row for each node
  /// @return the same of what they cause
  [[nodiscard]] virtual Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const = 0;

  /// @return floating-point operations of it, roughly
  [[nodiscard]] virtual double operations() const = 0;
};

/// @brief Harmonic by harmonic: forces are summed to the amplitude of each order and degree, and these to
/// displacements; what is above the degrees by transforms along both angles.
class FactoredSphereProduct : public SphereProduct {
 public:
  /// @param[in] shape window, no wider than the influence reaches
  /// @param[in] first_theta its first column, from the equator
  /// @param[in] influence of these and other nodes
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
  Eigen::Index half_;  // thetas of one side, that of the equator among them
  Eigen::Index components_;
  std::shared_ptr<const SphereInfluence> influence_;
  Eigen::MatrixXd waves_;               // [phi, 2 m] the cosine and [phi, 2 m + 1] minus the sine of m phi
  std::vector<Eigen::ArrayXd> metric_;  // [power] what each node of the window has of it
  std::optional<Convolution> local_;    // fields power * components + component
};

/// @brief The product that takes fewer operations: that of all influence in one table, as between few nodes, or
/// harmonic by harmonic. Parameters as for these.
[[nodiscard]] std::unique_ptr<const SphereProduct> make_sphere_product(WindowShape shape, int first_theta,
                                                                       std::shared_ptr<const SphereInfluence> influence,
                                                                       int threads, Watch& watch);

}  // namespace viscoroll::detail
