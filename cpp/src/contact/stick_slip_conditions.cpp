#include "contact/stick_slip_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr double kMinKeptFraction = 0.97;  // of the nodes that gap and slip of the coarse mesh put in contact

/// Traction of a node if its slip were reversed elastically, t - k_t S.
Eigen::Array2d trial_traction(const StickSlipSystem& system, const ContactSolution& state, Index node) {
  const Eigen::Array2d traction(state.force(node, kForward), state.force(node, kSideways));
  return traction - system.scales().tangential * state.slip.row(node).transpose();
}

}  // namespace

TangentialState sticking() { return {.stick = true, .direction = {1.0, 0.0}, .rigidity = 1.0}; }

TangentialState slipping(const StickSlipSystem& system, double friction, const ContactSolution& state, Index node) {
  const Eigen::Array2d trial = trial_traction(system, state, node);
  const double size = trial.matrix().norm();
  const double rigidity = friction * std::max(-state.force(node, kDown), 0.0) / size;
  return {.stick = false, .direction = trial / size, .rigidity = std::min(rigidity, 1.0)};
}

ContactSets find_sets(const StickSlipSystem& system, double friction, ContactSolution& state) {
  const ConditionScales scales = system.scales();
  const Index first_node = system.first_node();
  ContactSets sets;
  double violation = std::pow(system.imbalance(state), 2);
  for (Index node = 0; node < state.gap.size(); ++node) {
    const double pressing = -state.force(node, kDown);
    const double predicted = pressing - scales.normal * state.gap[node];
    const bool touches = predicted > 0.0 && node >= first_node;
    violation += std::pow(touches ? scales.normal * state.gap[node] : pressing, 2);
    const Eigen::Array2d traction(state.force(node, kForward), state.force(node, kSideways));
    if (!touches) {
      violation += traction.square().sum();
      continue;
    }
    const double limit = friction * predicted;
    sets.contact.push_back(node);
    if (trial_traction(system, state, node).matrix().norm() <= limit) {
      sets.states.push_back(sticking());
      violation += (scales.tangential * state.slip.row(node)).square().sum();
    } else {
      sets.states.push_back(slipping(system, friction, state, node));
      violation += (traction - limit * sets.states.back().direction).square().sum();
    }
  }
  state.residual = std::sqrt(violation) / system.load();
  return sets;
}

void keep_contact(const StickSlipSystem& system, double friction, ContactSolution& state, ContactSets& sets) {
  ContactSolution smooth = state;
  smooth.gap = std::move(state.prolonged->gap);
  smooth.slip = std::move(state.prolonged->slip);
  state.prolonged.reset();
  ContactSets kept = find_sets(system, friction, smooth);
  const auto count = [](const ContactSets& of) { return static_cast<double>(of.contact.size()); };
  if (count(sets) < kMinKeptFraction * count(kept)) sets = std::move(kept);
}

}  // namespace viscoroll::detail
