/// @file
/// @brief Two deformable surfaces in contact.
#pragma once

#include <memory>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Sum of the operators of the rolling body and of the counterbody on one window.
class SumOperator : public SurfaceOperator {
 public:
  /// @param[in] rolling operator of the rolling body
  /// @param[in] counterbody operator of the counterbody, on the same window
  SumOperator(std::shared_ptr<const SurfaceOperator> rolling, std::shared_ptr<const SurfaceOperator> counterbody);

  [[nodiscard]] const Window& window() const override { return rolling_->window(); }
  [[nodiscard]] const Execution& execution() const override { return rolling_->execution(); }
  [[nodiscard]] double collocation() const override { return rolling_->collocation(); }
  [[nodiscard]] const LocalCompliance& local() const override { return local_; }
  [[nodiscard]] Deforming deforming() const override { return Deforming::both; }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override {
    return displacements(force).relative();
  }
  [[nodiscard]] Displacements displacements(const VectorField& force) const override {
    return {.rolling = rolling_->displacement(force), .counterbody = counterbody_->displacement(force)};
  }
  [[nodiscard]] double row_distance() const override { return rolling_->row_distance(); }
  [[nodiscard]] double slope_force(const VectorField& force) const override { return counterbody_->slope_force(force); }
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override {
    return rolling_->normal_displacement(nodes, pressing) + counterbody_->normal_displacement(nodes, pressing);
  }
  [[nodiscard]] std::optional<Eigen::MatrixXd> normal_compliance(
      const std::vector<Eigen::Index>& displaced, const std::vector<Eigen::Index>& loaded) const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override {
    return std::make_shared<SumOperator>(rolling_->coarsened(), counterbody_->coarsened());
  }
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override {
    return std::make_shared<SumOperator>(rolling_->within(window), counterbody_->within(window));
  }
  [[nodiscard]] bool takes_mirrored() const override {
    return rolling_->takes_mirrored() && counterbody_->takes_mirrored();
  }
  [[nodiscard]] Losses dissipation(const VectorField& force) const override {
    return {.rolling = rolling_->dissipation(force).rolling,
            .counterbody = counterbody_->dissipation(force).counterbody};
  }

  [[nodiscard]] double operations() const override { return rolling_->operations() + counterbody_->operations(); }

 private:
  std::shared_ptr<const SurfaceOperator> rolling_;
  std::shared_ptr<const SurfaceOperator> counterbody_;
  LocalCompliance local_;
};

}  // namespace viscoroll::detail
