/// @file
/// @brief The surface of the exact sphere.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "influence/sphere_product.hpp"
#include "surface/corrected_operator.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {

/// @brief Displacements on the exact sphere, of what rolls or of what it rolls on, whose influence depends on both
/// thetas. Translation-invariant tables of the same coating with the membrane stiffness of a sphere stand for it in
/// scales and preconditioners.
class SphereOperator : public CorrectedOperator {
 public:
  using Influence = std::shared_ptr<const SphereInfluence>;
  /// Gives the influence on the power lost, for thetas from -half_theta to half_theta.
  using DissipationSource = std::function<Influence(int phi_reach, int half_theta)>;

  /// @param[in] nearby operator on the same window, with `Curvature::sphere`
  /// @param[in] influence on displacements, reaching across the window
  /// @param[in] dissipation_source influence on the dissipation
  SphereOperator(std::shared_ptr<const SurfaceOperator> nearby, Influence influence,
                 DissipationSource dissipation_source);

  [[nodiscard]] double operations() const override { return product_->operations(); }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override;
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override;
  /// Patches of twice the width lie on a whole patch and half of each neighbor.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override;
  /// From the spectral power of each degree and order, summed as the displacements are.
  [[nodiscard]] Losses dissipation(const VectorField& force) const override;

 private:
  Influence influence_;
  DissipationSource dissipation_source_;
  std::unique_ptr<const SphereProduct> product_;
};

}  // namespace viscoroll::detail
