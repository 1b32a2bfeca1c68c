#include "contact/stick_slip_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr double kLeastKept = 0.97;  // of a coarse mesh's contact

}  // namespace

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
    const Eigen::Array2d slip = state.slip.row(node).transpose();
    const Eigen::Array2d trial = traction - scales.tangential * slip;
    const double size = trial.matrix().norm();
    const double limit = friction * predicted;
    sets.contact.push_back(node);
    if (size <= limit) {
      sets.states.push_back({.stick = true, .direction = {1.0, 0.0}, .rigidity = 1.0});
      violation += (scales.tangential * slip).square().sum();
    } else {
      const Eigen::Array2d direction = trial / size;
      const double rigidity = friction * std::max(pressing, 0.0) / size;
      sets.states.push_back({.stick = false, .direction = direction, .rigidity = std::min(rigidity, 1.0)});
      violation += (traction - limit * direction).square().sum();
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
  if (count(sets) < kLeastKept * count(kept)) sets = std::move(kept);
}

}  // namespace viscoroll::detail
