#include "surface/free_sides_operator.hpp"

#include <utility>

#include "surface/pushback.hpp"

namespace viscoroll::detail {

FreeSidesOperator::FreeSidesOperator(std::shared_ptr<const SurfaceOperator> endless, Difference difference,
                                     SideFactors factors, DissipationSource dissipation_source,
                                     const NodeSpacing& spacing)
    : endless_(std::move(endless)),
      difference_(std::move(difference)),
      factors_(std::move(factors)),
      dissipation_source_(std::move(dissipation_source)),
      spacing_(spacing),
      product_(product(factors_, false)) {}

SideProduct FreeSidesOperator::product(const SideFactors& factors, bool average) const {
  const TreadColumns columns{.first = window().theta.first, .spacing = spacing_.across};
  return {shape(), columns, *difference_, factors, average};
}

VectorField FreeSidesOperator::addition(const VectorField& force) const {
  return local().displacements(product_.apply(local().loads(force)));
}

VectorField FreeSidesOperator::displacement(const VectorField& force) const {
  return endless_->displacement(force) + addition(force);
}

VectorField FreeSidesOperator::rolling_displacement(const VectorField& force) const {
  return bodies() == Bodies::counterpart ? VectorField(VectorField::Zero(force.rows(), 3)) : displacement(force);
}

double FreeSidesOperator::pushback(const VectorField& force) const {
  if (bodies() != Bodies::counterpart) return 0.0;
  return endless_->pushback(force) + pushback_by(addition(force), force, shape().theta_nodes, spacing_.along);
}

Eigen::VectorXd FreeSidesOperator::normal_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  VectorField force = VectorField::Zero(shape().size(), 3);
  for (Eigen::Index i = 0; i < pressing.size(); ++i) force(nodes.node(i), kDown) = pressing[i];
  const Eigen::ArrayXd added = addition(force).col(kDown);
  Eigen::VectorXd moved = endless_->normal_displacement(nodes, pressing);
  for (Eigen::Index i = 0; i < moved.size(); ++i) moved[i] += added[nodes.node(i)];
  return moved;
}

std::shared_ptr<const SurfaceOperator> FreeSidesOperator::coarsened() const {
  return std::make_shared<FreeSidesOperator>(
      endless_->coarsened(), difference_, widened(factors_, 2, collocation()),
      [source = dissipation_source_](int phi_reach) { return widened(widened(source(2 * phi_reach + 2), 1), 2); },
      NodeSpacing{.along = 2.0 * spacing_.along, .across = 2.0 * spacing_.across});
}

std::shared_ptr<const SurfaceOperator> FreeSidesOperator::within(const Window& window) const {
  return std::make_shared<FreeSidesOperator>(endless_->within(window), difference_, factors_, dissipation_source_,
                                             spacing_);
}

Losses FreeSidesOperator::dissipation(const VectorField& force) const {
  const Eigen::ArrayXXd loads = local().loads(force);
  const SideProduct product = this->product(dissipation_source_(shape().phi_nodes - 1), true);
  Losses losses = endless_->dissipation(force);
  (bodies() == Bodies::counterpart ? losses.counterpart : losses.rolling) += (loads * product.apply(loads)).sum();
  return losses;
}

}  // namespace viscoroll::detail
