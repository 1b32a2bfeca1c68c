/// @file
/// @brief Surface of the exact sphere.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "influence/sphere_product.hpp"
#include "surface/corrected_operator.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {

/// @brief Displacements on the exact sphere, of the rolling body or of the counterbody. The influence depends on theta
/// of both nodes. Scales and preconditioners use translation-invariant tables of the influence near the equator.
class SphereOperator : public CorrectedOperator {
 public:
  using Influence = std::shared_ptr<const SphereInfluence>;
  /// Function that returns the influence for the dissipated power, for theta from -half_theta to half_theta.
  using DissipationSource = std::function<Influence(int phi_reach, int half_theta)>;

  /// @param[in] nearby operator on the same window with the tables of `tables_around_equator`
  /// @param[in] influence influence for displacements, which reaches across the window
  /// @param[in] dissipation_source influence for the dissipated power
  SphereOperator(std::shared_ptr<const SurfaceOperator> nearby, Influence influence,
                 DissipationSource dissipation_source);

  [[nodiscard]] double operations() const override { return product_->operations(); }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override;
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override;
  /// Coarser mesh: a patch of twice the width covers a whole patch and half of each neighbor.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override;
  /// Dissipated work from the power of each degree and order, summed in the same way as the displacements.
  [[nodiscard]] Losses dissipation(const VectorField& force) const override;

 private:
  Influence influence_;
  DissipationSource dissipation_source_;
  std::unique_ptr<const SphereProduct> product_;
};

}  // namespace viscoroll::detail
