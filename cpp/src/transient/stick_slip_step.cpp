#include "transient/stick_slip_step.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "contact/semismooth_newton.hpp"
#include "contact/stick_slip_conditions.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

Eigen::ArrayX2d along_plane(const VectorField& displacement) {
  return displacement(Eigen::all, std::array{kForward, kSideways});
}

/// What rolls over what it rolls on: nodes slip from where they were a step ago, and dense factors solve the equations
/// of those that touch, or did lately.
class MatchedSurfaces : public StickSlipSystem {
 public:
  MatchedSurfaces(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness)
      : problem_(problem), equations_(problem, stiffness) {
    const bool is_single = problem.surface.parts().size() == 1;
    std::vector<HalfField> displaced;
    if (problem.center_moves || !is_single) displaced = problem.surface.displaced(guess);
    center_ = problem.center(displaced);
    equations_.drive(center_);
    if (is_single) return;
    const VectorField excess = problem.surface.excess(guess, displaced);
    std::vector<Index> all(static_cast<std::size_t>(problem.gap.size()));
    std::iota(all.begin(), all.end(), 0);
    equations_.correct(all, -excess.col(kDown), along_plane(excess));
  }

  [[nodiscard]] ConditionScales scales() const override {
    return {.normal = 1.0 / problem_.surface.own_compliance(), .tangential = 1.0 / equations_.own_compliance()};
  }
  [[nodiscard]] double load() const override { return problem_.load; }
  [[nodiscard]] Index first_node() const override { return 0; }
  /// The equations hold to round-off, but that the center's may have moved since.
  [[nodiscard]] double imbalance(const ContactSolution&) const override { return imbalance_; }
  [[nodiscard]] int products() const override { return products_; }

  void solve(double friction, const ContactSets& sets, double, ContactSolution& state) override {
    equations_.cover(sets.contact);
    const auto [forces, moves, penetration, way] = equations_.solve(conditions(friction, sets));
    state.penetration = penetration;
    state.creepage = way;
    imbalance_ = 0.0;
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
    const std::vector<HalfField> displaced = problem_.surface.displaced(state.force);
    state.displacement = problem_.surface.displacement(displaced);
    const Eigen::ArrayXd gap = std::move(state.gap);
    const Eigen::ArrayX2d slip = std::move(state.slip);
    state.gap = problem_.gap - state.displacement.col(kDown) - state.penetration * problem_.weights;
    state.slip = problem_.way + *state.creepage * problem_.by_center;
    state.slip += along_plane(state.displacement);
    equations_.correct(equations_.covered(), state.gap - gap, state.slip - slip);
    if (!problem_.center_moves) return;
    center_ = problem_.center(displaced);
    equations_.drive(center_);
    imbalance_ = (center_.on_force * state.force).sum() + center_.way * *state.creepage - center_.value;
  }

 private:
  [[nodiscard]] Index height() const { return problem_.surface.half_nodes(); }
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
  CenterRow center_;
  double imbalance_ = 0.0;
  int products_ = 0;
};

}  // namespace

StickSlip solve_stick_slip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness) {
  constexpr const FrictionSettings& kSettings = kFrictionSettings;
  MatchedSurfaces surfaces(problem, guess, stiffness);
  SemismoothNewton newton(surfaces, {.tolerance = kSettings.instant_tolerance,
                                     .round_off = kSettings.instant_round_off,
                                     .free_steps = kSettings.free_steps});
  // Who does what is first told by forces alone, for gaps and ways are those of the step before.
  const auto finds_from = [&](const VectorField& force) {
    ContactSolution state{.force = force,
                          .displacement = {},
                          .gap = Eigen::ArrayXd::Zero(force.rows()),
                          .contact = {},
                          .slip = Eigen::ArrayX2d::Zero(force.rows(), 2)};
    const ContactSets sets = find_sets(surfaces, kSettings.likely_slip * problem.friction, state);
    newton.start_from(std::move(state));
    newton.take_step(problem.friction, sets, kSettings.exact_step);
    return newton.iterate(problem.friction);
  };
  VectorField pressing = VectorField::Zero(guess.rows(), 3);
  pressing.col(kDown) = guess.col(kDown);
  if (!finds_from(guess) && !finds_from(pressing)) {
    throw ConvergenceError("stick and slip did not settle: friction may not bear what drives it", newton.systems(),
                           newton.state().residual);
  }
  const ContactSolution& state = newton.state();
  const ContactSets& sets = newton.sets();
  StickSlip result{.force = state.force, .penetration = state.penetration, .way = *state.creepage, .slip = state.slip};
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    if (!(result.force(sets.contact[i], kDown) < 0.0)) continue;
    result.nodes.push_back(sets.contact[i]);
    result.sticking += sets.states[i].stick ? 1 : 0;
  }
  return result;
}

}  // namespace viscoroll::detail
