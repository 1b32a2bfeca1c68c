#include "contact/stick_slip_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr double kLeastKept = 0.97;  // of a coarse mesh's contact

}  // namespace

StickSlipConditions::StickSlipConditions(const ContactProblem& problem)
    : problem_(problem),
      stride_(problem.surface->shape().theta_nodes),
      scales_(condition_scales(*problem.surface)),
      preconditioner_(*problem.surface) {}

void StickSlipConditions::find_displacements(ContactSolution& state) const {
  state.displacement = problem_.surface->displacement(state.force);
  ++state.operator_applications;
  state.gap = problem_.initial_gap - state.displacement.col(kDown) - state.penetration;
  state.slip = slip(*problem_.friction, stride_, state.displacement, *state.creepage);
}

ContactSets StickSlipConditions::sets(double friction, ContactSolution& state) const {
  return classify(friction, state.gap, state.slip, state);
}

/// Who touches, sticks and slips next, and how far all conditions are from holding.
ContactSets StickSlipConditions::classify(double friction, const Eigen::ArrayXd& gap, const Eigen::ArrayX2d& slips,
                                          ContactSolution& state) const {
  ContactSets sets;
  double violation = std::pow(imbalance(state), 2);
  for (Index node = 0; node < problem_.initial_gap.size(); ++node) {
    const double pressing = -state.force(node, kDown);
    const double predicted = pressing - scales_.normal * gap[node];
    const bool touches = predicted > 0.0 && node >= stride_;
    violation += std::pow(touches ? scales_.normal * gap[node] : pressing, 2);
    const Eigen::Array2d traction(state.force(node, kForward), state.force(node, kSideways));
    if (!touches) {
      violation += traction.square().sum();
      continue;
    }
    const Eigen::Array2d slip = slips.row(node).transpose();
    const Eigen::Array2d trial = traction - scales_.tangential * slip;
    const double size = trial.matrix().norm();
    const double limit = friction * predicted;
    sets.contact.push_back(node);
    if (size <= limit) {
      sets.states.push_back({.stick = true, .direction = {1.0, 0.0}, .rigidity = 1.0});
      violation += (scales_.tangential * slip).square().sum();
    } else {
      const Eigen::Array2d direction = trial / size;
      const double rigidity = friction * std::max(pressing, 0.0) / size;
      sets.states.push_back({.stick = false, .direction = direction, .rigidity = std::min(rigidity, 1.0)});
      violation += (traction - limit * direction).square().sum();
    }
  }
  state.residual = std::sqrt(violation) / problem_.normal_force;
  return sets;
}

void StickSlipConditions::keep_contact(double friction, ContactSolution& state, ContactSets& sets) const {
  const SmoothFields fields = *std::exchange(state.prolonged, std::nullopt);
  const double residual = state.residual;
  ContactSets kept = classify(friction, fields.gap, fields.slip, state);
  state.residual = residual;
  const auto count = [](const ContactSets& of) { return static_cast<double>(of.contact.size()); };
  if (count(sets) < kLeastKept * count(kept)) sets = std::move(kept);
}

void StickSlipConditions::take_step(double friction, const ContactSets& sets, double tolerance,
                                    ContactSolution& state) const {
  take_newton_step(problem_, friction, scales_, sets, preconditioner_, tolerance, state);
}

double StickSlipConditions::drive_excess(const ContactSolution& state) const {
  const DriveRow drive =
      problem_.friction->drive->row({*problem_.surface, problem_.friction->arms, state.force, state.displacement},
                                    scales_.tangential * problem_.friction->step);
  return drive.of(state.force, state.displacement, *state.creepage) - drive.value;
}

double StickSlipConditions::creep(const ContactSolution& state, const ContactSets& sets) const {
  const auto upstream = [&](Index node) { return node - stride_; };
  std::vector<Index> from(sets.contact.size());
  std::ranges::transform(sets.contact, from.begin(), upstream);
  const auto& moved = state.displacement;
  Eigen::ArrayX2d ways(static_cast<Index>(from.size()), 2);
  ways.col(0) = moved.col(kForward)(sets.contact) - moved.col(kForward)(from);
  ways.col(1) = moved.col(kSideways)(sets.contact) - moved.col(kSideways)(from);
  const double spread =
      std::hypot(ways.col(0).maxCoeff() - ways.col(0).minCoeff(), ways.col(1).maxCoeff() - ways.col(1).minCoeff());
  double slip = 0.0;
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    if (sets.states[i].stick) slip = std::max(slip, state.slip.row(sets.contact[i]).matrix().norm());
  }
  return spread > 0.0 ? slip / spread : 0.0;
}

/// How far load and drive are from balance [N].
double StickSlipConditions::imbalance(const ContactSolution& state) const {
  return std::hypot(-state.force.col(kDown).sum() - problem_.normal_force, drive_excess(state));
}

}  // namespace viscoroll::detail
