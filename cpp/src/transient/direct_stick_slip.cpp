#include "transient/direct_stick_slip.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

Eigen::ArrayX2d along_plane(const VectorField& displacement) {
  return displacement(Eigen::all, std::array{kForward, kSideways});
}

/// With several bodies, the stiffness is that of the level window, and the difference to it is an excess.
bool has_excess(const StickSlipProblem& problem) { return problem.surface.parts().size() > 1; }

std::vector<HalfField> displaced_by(const StickSlipProblem& problem, const VectorField& guess) {
  if (!problem.center_row_needs_displacements && !has_excess(problem)) return {};
  return problem.surface.displaced(guess);
}

}  // namespace

DirectStickSlip::DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness)
    : DirectStickSlip(problem, guess, displaced_by(problem, guess), stiffness) {}

DirectStickSlip::DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess,
                                 const std::vector<HalfField>& displaced, ContactStiffness& stiffness)
    : TransientStickSlipSystem(problem, displaced), equations_(problem, 1.0 / scales().tangential, stiffness) {
  equations_.set_center_condition(center());
  if (!has_excess(problem)) return;
  const VectorField excess = problem.surface.excess(guess, displaced);
  std::vector<Index> all(static_cast<std::size_t>(problem.gap.size()));
  std::iota(all.begin(), all.end(), 0);
  equations_.correct(all, -excess.col(kDown), along_plane(excess));
}

void DirectStickSlip::solve(double friction, const ContactSets& sets, double, ContactSolution& state) {
  problem().surface.checkpoint();
  equations_.cover(sets.contact);
  const auto [forces, free_displacements, penetration, center_displacement] =
      equations_.solve(conditions(friction, sets));
  state.penetration = penetration;
  state.creepage = center_displacement;
  imbalance_ = 0.0;
  state.force.setZero();
  state.gap.setZero();
  state.slip.setZero();
  state.displacement.resize(0, 3);
  for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
    const Index node = equations_.covered()[i];
    const auto move = free_displacements.segment<3>(static_cast<Index>(3 * i)).array();
    state.gap[node] = -move[kDown];
    state.slip.row(node) << move[kForward], move[kSideways];
    if (std::ranges::binary_search(sets.contact, node)) {
      state.force.row(node) = forces.segment<3>(static_cast<Index>(3 * i)).transpose();
      if (in_middle(node)) state.force(node, kSideways) = 0.0;
    }
  }
}

void DirectStickSlip::find_displacements(ContactSolution& state) {
  const Eigen::ArrayXd gap = std::move(state.gap);
  const Eigen::ArrayX2d slip = std::move(state.slip);
  TransientStickSlipSystem::find_displacements(state);
  equations_.correct(equations_.covered(), state.gap - gap, state.slip - slip);
  if (!problem().center_row_needs_displacements) return;
  equations_.set_center_condition(center());
  imbalance_ = center_excess(state);
}

/// Conditions of the sets. A separated node has zero force. At a slipping node, the traction is limited by friction,
/// and across the slip direction it turns with the slip. Nodes on the middle line do not move sideways.
std::vector<Condition> DirectStickSlip::conditions(double friction, const ContactSets& sets) const {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
    const Index node = equations_.covered()[i];
    const auto add = [&](Axis axis, const Eigen::Vector3d& force_coefficients,
                         const Eigen::Vector3d& displacement_coefficients) {
      conditions.push_back(
          {static_cast<Index>(i), axis, force_coefficients / scales().tangential, displacement_coefficients});
    };
    const auto found = std::ranges::lower_bound(sets.contact, node);
    if (found == sets.contact.end() || *found != node) {
      for (const Axis axis : {kForward, kDown, kSideways}) {
        if (axis == kSideways && in_middle(node)) continue;
        add(axis, Eigen::Vector3d::Unit(axis), Eigen::Vector3d::Zero());
      }
      continue;
    }
    const auto& [stick, e, rigidity] = sets.states[static_cast<std::size_t>(found - sets.contact.begin())];
    if (stick) continue;
    const Eigen::Vector3d across(-e[1], 0.0, e[0]);
    add(kForward, {e[0], friction, e[1]}, Eigen::Vector3d::Zero());
    if (!in_middle(node)) add(kSideways, (1.0 - rigidity) * across, rigidity * across);
  }
  return conditions;
}

}  // namespace viscoroll::detail
