/// @file
/// @brief The surface of a tread that ends at two faces.
#pragma once

#include <functional>
#include <memory>

#include "influence/side_product.hpp"
#include "influence/side_sum.hpp"
#include "surface/corrected_operator.hpp"

namespace viscoroll::detail {

/// @brief An endless tread's surface, and what the faces add to it. Scales and preconditioners are those of the endless
/// one.
class FreeSidesOperator : public CorrectedOperator {
 public:
  using Difference = std::shared_ptr<const SampledDifference>;
  /// Gives factors of the power lost.
  using DissipationSource = std::function<SideFactors(int phi_reach)>;

  /// @param[in] endless operator on the same window
  /// @param[in] difference of the section
  /// @param[in] factors of displacements, reaching across the window
  /// @param[in] dissipation_source those of the power lost
  /// @param[in] column_distance between neighbors across [m]
  FreeSidesOperator(std::shared_ptr<const SurfaceOperator> endless, Difference difference, SideFactors factors,
                    DissipationSource dissipation_source, double column_distance);

  [[nodiscard]] double operations() const override { return nearby().operations() + product_.operations(); }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override;
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override;
  /// Patches of twice the length lie on a whole patch and half of each neighbor.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override;
  /// From the power of every order, summed as the displacements are.
  [[nodiscard]] Losses dissipation(const VectorField& force) const override;

 private:
  [[nodiscard]] SideProduct product(const SideFactors& factors, bool average) const;
  /// What the faces add.
  [[nodiscard]] VectorField addition(const VectorField& force) const;

  Difference difference_;
  SideFactors factors_;
  DissipationSource dissipation_source_;
  double column_distance_;  // [m]
  SideProduct product_;
};

}  // namespace viscoroll::detail
