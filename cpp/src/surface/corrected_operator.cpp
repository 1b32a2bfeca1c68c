#include "surface/corrected_operator.hpp"

#include <algorithm>
#include <utility>

namespace viscoroll::detail {

FreeSidesOperator::FreeSidesOperator(std::shared_ptr<const SurfaceOperator> unbounded, Difference difference,
                                     SideFactors factors, DissipationSource dissipation_source, double column_distance)
    : CorrectedOperator(std::move(unbounded)),
      difference_(std::move(difference)),
      factors_(std::move(factors)),
      dissipation_source_(std::move(dissipation_source)),
      column_distance_(column_distance),
      product_(product(factors_, false)) {}

SideProduct FreeSidesOperator::product(const SideFactors& factors, bool average) const {
  const TreadColumns columns{.first = window().theta.first, .spacing = column_distance_};
  return {shape(), columns, *difference_, factors, average};
}

VectorField FreeSidesOperator::addition(const VectorField& force) const {
  return local().displacements(product_.apply(local().loads(force)));
}

VectorField FreeSidesOperator::displacement(const VectorField& force) const {
  return nearby().displacement(force) + addition(force);
}

Eigen::VectorXd FreeSidesOperator::normal_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  VectorField force = VectorField::Zero(shape().size(), 3);
  for (Eigen::Index i = 0; i < pressing.size(); ++i) force(nodes.node(i), kDown) = pressing[i];
  const Eigen::ArrayXd added = addition(force).col(kDown);
  Eigen::VectorXd moved = nearby().normal_displacement(nodes, pressing);
  for (Eigen::Index i = 0; i < moved.size(); ++i) moved[i] += added[nodes.node(i)];
  return moved;
}

std::shared_ptr<const SurfaceOperator> FreeSidesOperator::coarsened() const {
  return std::make_shared<FreeSidesOperator>(
      nearby().coarsened(), difference_, widened(factors_, 2, collocation()),
      [source = dissipation_source_](int phi_reach) { return widened(widened(source(2 * phi_reach + 2), 1), 2); },
      2.0 * column_distance_);
}

std::shared_ptr<const SurfaceOperator> FreeSidesOperator::within(const Window& window) const {
  return std::make_shared<FreeSidesOperator>(nearby().within(window), difference_, factors_, dissipation_source_,
                                             column_distance_);
}

Losses FreeSidesOperator::dissipation(const VectorField& force) const {
  const Eigen::ArrayXXd loads = local().loads(force);
  const SideProduct product = this->product(dissipation_source_(shape().phi_nodes - 1), true);
  const Losses unbounded = nearby().dissipation(force);
  return losses(unbounded.sum() + (loads * product.apply(loads)).sum());
}

SphereOperator::SphereOperator(std::shared_ptr<const SurfaceOperator> nearby, Influence influence,
                               DissipationSource dissipation_source)
    : CorrectedOperator(std::move(nearby)),
      influence_(std::move(influence)),
      dissipation_source_(std::move(dissipation_source)),
      product_(make_sphere_product(shape(), window().theta.first, influence_, execution().threads, execution().watch)) {
}

VectorField SphereOperator::displacement(const VectorField& force) const {
  return local().displacements(product_->apply(local().loads(force), execution().threads, execution().watch));
}

Eigen::VectorXd SphereOperator::normal_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  VectorField force = VectorField::Zero(shape().size(), 3);
  for (Eigen::Index i = 0; i < pressing.size(); ++i) force(nodes.node(i), kDown) = pressing[i];
  const Eigen::ArrayXd moved = displacement(force).col(kDown);
  return Eigen::VectorXd::NullaryExpr(pressing.size(), [&](Eigen::Index i) { return moved[nodes.node(i)]; });
}

std::shared_ptr<const SurfaceOperator> SphereOperator::coarsened() const {
  return std::make_shared<SphereOperator>(
      nearby().coarsened(),
      std::make_shared<const SphereInfluence>(with_wide_patches(*influence_, collocation(), false)),
      [source = dissipation_source_](int phi_reach, int half_theta) {
        const Influence fine = source(2 * phi_reach + 2, 2 * half_theta + 2);
        return std::make_shared<const SphereInfluence>(with_wide_patches(*fine, 0.0, true));
      });
}

std::shared_ptr<const SurfaceOperator> SphereOperator::within(const Window& window) const {
  return std::make_shared<SphereOperator>(nearby().within(window), influence_, dissipation_source_);
}

Losses SphereOperator::dissipation(const VectorField& force) const {
  const int half_theta = std::max(-window().theta.first, window().theta.last);
  const Influence influence = dissipation_source_(shape().phi_nodes - 1, half_theta);
  const FactoredSphereProduct product(shape(), window().theta.first, influence, execution().threads, execution().watch);
  const Eigen::ArrayXXd loads = local().loads(force);
  return losses((loads * product.apply(loads, execution().threads, execution().watch)).sum());
}

}  // namespace viscoroll::detail
