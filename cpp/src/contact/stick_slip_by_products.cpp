#include "contact/stick_slip_by_products.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/friction_settings.hpp"
#include "contact/newton_step.hpp"

namespace viscoroll::detail {

using Eigen::Index;

StickSlipByProducts::StickSlipByProducts(const ContactProblem& problem)
    : problem_(problem),
      stride_(problem.surface->shape().theta_nodes),
      scales_({.normal = problem.surface->normal_stiffness(), .tangential = problem.surface->slip_stiffness()}),
      preconditioner_(*problem.surface) {}

double StickSlipByProducts::imbalance(const ContactSolution& state) const {
  const NormalCondition condition = problem_.normal_condition(scales_.normal);
  const double normal = condition.per_force * pressing_force(state).sum() +
                        condition.per_penetration * scales_.normal * state.penetration;
  return std::hypot(normal - condition.value, drive_excess(state));
}

void StickSlipByProducts::find_displacements(ContactSolution& state) {
  detail::find_displacements(*problem_.surface, state);
  ++products_;
  state.gap = problem_.initial_gap - state.displacement.col(kDown) - state.penetration;
  state.slip = slip(*problem_.friction, stride_, state);
}

void StickSlipByProducts::solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) {
  products_ += take_newton_step(problem_, friction, scales_, sets, preconditioner_, tolerance, state);
  if (!problem_.friction->drive->given_creepage()) {
    const double most = kFrictionSettings.max_creepage;
    state.creepage = std::clamp(*state.creepage, -most, most);
  }
  find_displacements(state);
}

double StickSlipByProducts::drive_excess(const ContactSolution& state) const {
  const DriveRow drive =
      problem_.friction->drive->row({*problem_.surface, problem_.friction->arms, state.force, own_displacement(state)},
                                    scales_.tangential * problem_.friction->step);
  return drive.of(state.force, state.displacement, *state.creepage) - drive.value;
}

double StickSlipByProducts::slip_of_sticking_nodes(const ContactSolution& state, const ContactSets& sets) const {
  const auto upstream = [&](Index node) { return node - stride_; };
  std::vector<Index> from(sets.contact.size());
  std::ranges::transform(sets.contact, from.begin(), upstream);
  const auto& moved = state.displacement;
  Eigen::ArrayX2d increment(static_cast<Index>(from.size()), 2);
  increment.col(0) = moved.col(kForward)(sets.contact) - moved.col(kForward)(from);
  increment.col(1) = moved.col(kSideways)(sets.contact) - moved.col(kSideways)(from);
  const double spread = std::hypot(increment.col(0).maxCoeff() - increment.col(0).minCoeff(),
                                   increment.col(1).maxCoeff() - increment.col(1).minCoeff());
  double slip = 0.0;
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    if (sets.states[i].stick) slip = std::max(slip, state.slip.row(sets.contact[i]).matrix().norm());
  }
  return spread > 0.0 ? slip / spread : 0.0;
}

}  // namespace viscoroll::detail
