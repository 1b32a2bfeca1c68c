/// @file
/// @brief Operators that correct another operator, from which they differ little: the surface of a tread that ends at
/// two free faces, and the surface of the exact sphere.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "influence/side_influence.hpp"
#include "influence/sphere_product.hpp"
#include "surface/surface_operator.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {

/// @brief Operator with its own products, whose window, body and local compliance are those of the operator that it
/// corrects.
class CorrectedOperator : public SurfaceOperator {
 public:
  [[nodiscard]] const Window& window() const override { return nearby_->window(); }
  [[nodiscard]] const Execution& execution() const override { return nearby_->execution(); }
  [[nodiscard]] double collocation() const override { return nearby_->collocation(); }
  [[nodiscard]] const LocalCompliance& local() const override { return nearby_->local(); }
  [[nodiscard]] Deforming deforming() const override { return nearby_->deforming(); }
  [[nodiscard]] double row_distance() const override { return nearby_->row_distance(); }

 protected:
  /// @param[in] nearby operator on the same window that this one corrects
  explicit CorrectedOperator(std::shared_ptr<const SurfaceOperator> nearby) : nearby_(std::move(nearby)) {}
  [[nodiscard]] const SurfaceOperator& nearby() const { return *nearby_; }

 private:
  std::shared_ptr<const SurfaceOperator> nearby_;
};

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
