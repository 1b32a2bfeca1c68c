/// @file
/// @brief Surface of a tread that ends at two free faces.
#pragma once

#include <functional>
#include <memory>

#include "influence/side_product.hpp"
#include "influence/side_sum.hpp"
#include "surface/corrected_operator.hpp"

namespace viscoroll::detail {

/// @brief Operator of an unbounded tread plus the effect of the faces. Scales and preconditioners are those of the
/// unbounded tread.
class FreeSidesOperator : public CorrectedOperator {
 public:
  using Difference = std::shared_ptr<const SampledDifference>;
  /// Function that returns the factors of the dissipated power.
  using DissipationSource = std::function<SideFactors(int phi_reach)>;

  /// @param[in] unbounded operator of the unbounded tread on the same window
  /// @param[in] difference difference between the section with faces and the unbounded section
  /// @param[in] factors factors of the displacements, which reach across the window
  /// @param[in] dissipation_source factors of the dissipated power
  /// @param[in] column_distance distance between neighbors across the path [m]
  FreeSidesOperator(std::shared_ptr<const SurfaceOperator> unbounded, Difference difference, SideFactors factors,
                    DissipationSource dissipation_source, double column_distance);

  [[nodiscard]] double operations() const override { return nearby().operations() + product_.operations(); }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override;
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override;
  /// Coarser mesh: a patch of twice the length covers a whole patch and half of each neighbor.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override;
  /// Dissipated work from the power of every order, summed in the same way as the displacements.
  [[nodiscard]] Losses dissipation(const VectorField& force) const override;

 private:
  [[nodiscard]] SideProduct product(const SideFactors& factors, bool average) const;
  /// Displacements due to the faces.
  [[nodiscard]] VectorField addition(const VectorField& force) const;

  Difference difference_;
  SideFactors factors_;
  DissipationSource dissipation_source_;
  double column_distance_;  // [m]
  SideProduct product_;
};

}  // namespace viscoroll::detail
