#include "contact/flat_equations.hpp"

#include <cmath>
#include <numbers>

#include "influence/fft.hpp"

namespace viscoroll::detail {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

InverseConvolution normal_inverse(const SurfaceOperator& surface) {
  const WindowShape shape = surface.shape();
  const WindowShape period = surface.period().value_or(
      WindowShape{RealFft::fast_length(shape.phi_nodes), RealFft::fast_length(shape.theta_nodes)});
  const Execution& execution = surface.execution();
  return {shape,
          period,
          std::vector{&surface.local().table(Entry::rr)},
          std::vector<ConvolutionTerm>{{.result = 0, .table = 0, .operand = 0, .sign = 1.0}},
          execution.threads,
          execution.watch};
}

FlatEquations::FlatEquations(const ContactProblem& problem, const InverseConvolution& inverse,
                             const std::vector<Index>& nodes, bool mirrored, double stiffness, const ArrayXd* uniform,
                             const LawRows* law)
    : problem_(problem),
      inverse_(inverse),
      rows_(problem.surface->shape(), nodes, mirrored),
      count_(rows_.count()),
      roots_(VectorXd::Ones(count_)),
      stiffness_(stiffness),
      condition_(problem.normal_condition(stiffness_)),
      balance_(1.0 / std::sqrt(static_cast<double>(nodes.size()))),
      law_(law) {
  if (mirrored) {
    for_nodes([&](Index i, Index k) { roots_[i] = k > 0 ? std::numbers::sqrt2 : 1.0; });
  }
  VectorXd lowered = roots_;
  if (law) {
    factors_.emplace(VectorXd(count_), VectorXd(count_));
    for (Index i = 0; i < count_; ++i) {
      factors_->displacement[i] = law->displacement[rows_.node(i)];
      factors_->force[i] = law->force[rows_.node(i)];
      if (factors_->force[i] != 0.0) lowered[i] = 0.0;
    }
  }
  uniform_ = uniform ? unknown_forces(*uniform) : precondition_forces(lowered);
}

VectorXd FlatEquations::right_side() const {
  VectorXd right(count_ + 1);
  for (Index i = 0; i < count_; ++i) {
    const Index node = rows_.node(i);
    right[i] = law_ ? roots_[i] * law_->right[node] : -stiffness_ * roots_[i] * problem_.initial_gap[node];
  }
  right[count_] = balance_ * condition_.value;
  return right;
}

VectorXd FlatEquations::unknowns(const ArrayXd& pressing, double penetration) const {
  VectorXd unknowns(count_ + 1);
  unknowns.head(count_) = unknown_forces(pressing);
  unknowns[count_] = stiffness_ * penetration;
  return unknowns;
}

VectorXd FlatEquations::corrected(VectorXd unknowns) const {
  const double lowering = (condition_.value - conditioned(unknowns)) / response();
  unknowns.head(count_) += lowering * uniform_;
  unknowns[count_] += lowering;
  return unknowns;
}

VectorXd FlatEquations::residual(const VectorXd& unknowns, const ArrayXd& gap) const {
  VectorXd residual(count_ + 1);
  for (Index i = 0; i < count_; ++i) residual[i] = -stiffness_ * roots_[i] * gap[rows_.node(i)];
  residual[count_] = balance_ * (condition_.value - conditioned(unknowns));
  return residual;
}

ArrayXd FlatEquations::pressing(const VectorXd& unknowns) const {
  const double missing = condition_.value - conditioned(unknowns);
  return on_window(unknowns.head(count_) + missing / response() * uniform_);
}

double FlatEquations::penetration(const VectorXd& unknowns) const {
  return problem_.penetration.value_or(unknowns[count_] / stiffness_);
}

VectorXd FlatEquations::unknown_forces(const ArrayXd& forces) const {
  VectorXd unknowns(count_);
  for (Index i = 0; i < count_; ++i) unknowns[i] = roots_[i] * forces[rows_.node(i)];
  return unknowns;
}

ArrayXd FlatEquations::on_window(const VectorXd& unknowns) const {
  ArrayXd forces = ArrayXd::Zero(problem_.initial_gap.size());
  for_nodes([&](Index i, Index k) {
    const double force = unknowns[i] / roots_[i];
    forces[rows_.node(i)] = force;
    if (rows_.mirrored()) forces[rows_.node(i) - 2 * k] = force;
  });
  return forces;
}

VectorXd FlatEquations::times(const VectorXd& unknowns) const {
  scaled_ = unknowns.head(count_).cwiseQuotient(roots_);
  scaled_ = problem_.surface->normal_displacement(rows_, scaled_);
  VectorXd result(count_ + 1);
  result.head(count_) = roots_.cwiseProduct(stiffness_ * scaled_);
  result.head(count_) -= unknowns[count_] * roots_;
  if (factors_) {
    result.head(count_) =
        factors_->displacement.cwiseProduct(result.head(count_)) + factors_->force.cwiseProduct(unknowns.head(count_));
  }
  result[count_] = balance_ * conditioned(unknowns);
  return result;
}

VectorXd FlatEquations::precondition(const VectorXd& right) const {
  VectorXd result(count_ + 1);
  result.head(count_) = precondition_forces(right.head(count_));
  result[count_] = (right[count_] / balance_ - condition_.per_force * sum(result)) / response();
  result.head(count_) += result[count_] * uniform_;
  return result;
}

VectorXd FlatEquations::precondition_forces(const Eigen::Ref<const VectorXd>& right) const {
  const Execution& execution = problem_.surface->execution();
  scaled_ = right.cwiseQuotient(stiffness_ * roots_);
  if (factors_) scaled_ = (factors_->force.array() == 0.0).select(scaled_, 0.0);
  VectorXd forces = inverse_.apply(rows_, scaled_, execution.threads, execution.watch);
  forces = roots_.cwiseProduct(forces);
  if (factors_) {
    for (Index i = 0; i < count_; ++i) {
      if (factors_->force[i] != 0.0) forces[i] = right[i] / factors_->force[i];
    }
  }
  return forces;
}

}  // namespace viscoroll::detail
