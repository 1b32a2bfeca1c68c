#include "transient/stick_slip_step.hpp"

#include <algorithm>
#include <utility>

#include "contact/semismooth_newton.hpp"
#include "contact/stick_slip_conditions.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// A coating over the plane: nodes slip from where they were a step ago, and dense factors solve the equations of those
/// that touch, or did lately.
class CoatingOnPlane : public StickSlipSystem {
 public:
  CoatingOnPlane(const StickSlipProblem& problem, ContactStiffness& stiffness)
      : problem_(problem), equations_(problem, stiffness) {}

  [[nodiscard]] ConditionScales scales() const override {
    return {.normal = 1.0 / problem_.tables.own_compliance(), .tangential = 1.0 / equations_.own_compliance()};
  }
  [[nodiscard]] double load() const override { return problem_.load; }
  [[nodiscard]] Index first_node() const override { return 0; }
  /// The equations hold to round-off.
  [[nodiscard]] double imbalance(const ContactSolution&) const override { return 0.0; }
  [[nodiscard]] int products() const override { return products_; }

  void solve(double friction, const ContactSets& sets, double, ContactSolution& state) override {
    equations_.cover(sets.contact);
    const auto [forces, moves, penetration, way] = equations_.solve(conditions(friction, sets));
    state.penetration = penetration;
    state.creepage = way;
    state.force.setZero();
    state.gap.setZero();
    state.slip.setZero();
    state.displacement.resize(0, 3);
    for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
      const Index node = equations_.covered()[i];
      const auto move = moves.segment<3>(static_cast<Index>(3 * i)).array();
      state.gap[node] = -move[kDown];
      state.slip.row(node) << move[kForward], move[kSideways];
      if (std::ranges::binary_search(sets.contact, node)) {
        state.force.row(node) = forces.segment<3>(static_cast<Index>(3 * i)).transpose();
        if (in_middle(node)) state.force(node, kSideways) = 0.0;
      }
    }
  }

  void find_displacements(ContactSolution& state) override {
    ++products_;
    const auto bears = [&](Index node) { return (state.force.row(node) != 0.0).any(); };
    Index first = 0;
    Index last = state.force.rows() - 1;
    while (first < last && !bears(first)) ++first;
    while (first < last && !bears(last)) --last;
    in_reach_ =
        problem_.tables.displacement_in_reach(on_plane(problem_.axes, state.force), first / height(), last / height());
    const HalfField moved = -in_reach_.middleCols(problem_.tables.reach(), state.force.rows() / height());
    state.displacement.resize(state.force.rows(), 3);
    for (std::size_t axis = 0; axis < problem_.axes.size(); ++axis) {
      state.displacement.col(static_cast<Index>(axis)) = along(problem_.axes[axis], moved).reshaped();
    }
    state.gap = problem_.gap - state.displacement.col(kDown) - state.penetration * problem_.weights;
    state.slip.col(0) = problem_.forward_way + *state.creepage * problem_.weights + state.displacement.col(kForward);
    state.slip.col(1) = problem_.sideways_way + state.displacement.col(kSideways);
  }

  /// Of the last state whose displacements were asked for.
  [[nodiscard]] HalfField displacement_in_reach() && { return std::move(in_reach_); }

 private:
  [[nodiscard]] Index height() const { return problem_.tables.half_nodes(); }
  [[nodiscard]] bool in_middle(Index node) const { return node % height() == 0; }

  /// A node apart bears no force; one that slips bears what friction allows, and along the normal of its slip the
  /// traction turns with it. In the middle nothing moves sideways.
  [[nodiscard]] std::vector<Condition> conditions(double friction, const ContactSets& sets) const {
    std::vector<Condition> conditions;
    for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
      const Index node = equations_.covered()[i];
      const auto add = [&](Axis axis, const Eigen::Vector3d& on_force, const Eigen::Vector3d& on_move) {
        conditions.push_back({static_cast<Index>(i), axis, equations_.own_compliance() * on_force, on_move});
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

  const StickSlipProblem& problem_;
  StickSlipEquations equations_;
  HalfField in_reach_;
  int products_ = 0;
};

}  // namespace

StickSlip solve_stick_slip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness) {
  constexpr const FrictionSettings& kSettings = kFrictionSettings;
  CoatingOnPlane coating(problem, stiffness);
  SemismoothNewton newton(coating, {.tolerance = kSettings.instant_tolerance,
                                    .round_off = kSettings.instant_round_off,
                                    .free_steps = kSettings.free_steps});
  // Who does what is first told by forces alone, for gaps and ways are those of the step before.
  const auto finds_from = [&](const VectorField& force) {
    ContactSolution state{.force = force,
                          .displacement = {},
                          .gap = Eigen::ArrayXd::Zero(force.rows()),
                          .contact = {},
                          .slip = Eigen::ArrayX2d::Zero(force.rows(), 2)};
    const ContactSets sets = find_sets(coating, kSettings.likely_slip * problem.friction, state);
    newton.start_from(std::move(state));
    newton.take_step(problem.friction, sets, kSettings.exact_step);
    return newton.iterate(problem.friction);
  };
  VectorField pressing = VectorField::Zero(guess.rows(), 3);
  pressing.col(kDown) = guess.col(kDown);
  if (!finds_from(guess) && !finds_from(pressing)) {
    throw ConvergenceError("stick and slip did not settle", newton.systems(), newton.state().residual);
  }
  const ContactSolution& state = newton.state();
  const ContactSets& sets = newton.sets();
  StickSlip result{.force = state.force,
                   .penetration = state.penetration,
                   .way = *state.creepage,
                   .slip = state.slip,
                   .displacement = std::move(coating).displacement_in_reach()};
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    if (!(result.force(sets.contact[i], kDown) < 0.0)) continue;
    result.nodes.push_back(sets.contact[i]);
    result.sticking += sets.states[i].stick ? 1 : 0;
  }
  return result;
}

}  // namespace viscoroll::detail
