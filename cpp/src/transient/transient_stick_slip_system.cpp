#include "transient/transient_stick_slip_system.hpp"

namespace viscoroll::detail {
namespace {

ConditionScales scales_of(const StickSlipProblem& problem) {
  const StepOperator& surface = problem.surface;
  const Eigen::Index in_the_middle = problem.gap.size() / surface.half_nodes() / 2 * surface.half_nodes();
  return {.normal = 1.0 / surface.diagonal_compliance(), .tangential = 1.0 / surface.compliance_along(in_the_middle)};
}

}  // namespace

TransientStickSlipSystem::TransientStickSlipSystem(const StickSlipProblem& problem,
                                                   const std::vector<HalfField>& displaced)
    : problem_(problem), scales_(scales_of(problem)), center_(problem.center_row(displaced)) {}

void TransientStickSlipSystem::find_displacements(ContactSolution& state) {
  ++products_;
  const std::vector<HalfField> displaced = problem_.surface.displaced(state.force);
  state.displacement = problem_.surface.displacement(displaced);
  state.gap = problem_.gap - state.displacement.col(kDown) - state.penetration * problem_.weights;
  state.slip = problem_.known_slip + *state.creepage * problem_.slip_per_center_displacement;
  state.slip.col(0) += state.displacement.col(kForward);
  state.slip.col(1) += state.displacement.col(kSideways);
  if (problem_.center_row_needs_displacements) center_ = problem_.center_row(displaced);
}

double TransientStickSlipSystem::center_excess(const ContactSolution& state) const {
  return (center_.force_coefficients * state.force).sum() + center_.displacement * *state.creepage - center_.value;
}

}  // namespace viscoroll::detail
