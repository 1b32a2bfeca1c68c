#include "transient/stick_slip.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "base/validate.hpp"
#include "contact/semismooth_newton.hpp"
#include "contact/stick_slip_conditions.hpp"
#include "transient/elastic_contact.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

ConditionScales scales_of(const StickSlipProblem& problem) {
  const StepOperator& surface = problem.surface;
  const Index in_the_middle = problem.gap.size() / surface.half_nodes() / 2 * surface.half_nodes();
  return {.normal = 1.0 / surface.diagonal_compliance(), .tangential = 1.0 / surface.compliance_along(in_the_middle)};
}

/// Largest number of contact nodes for which dense factors pay. Two deformable balls take twice as long by products
/// with 300 nodes, equally long with 550 (two thirds with dissimilar layers), and half as long with 1500. Factors also
/// need nine numbers for each pair of nodes.
constexpr Index kMaxDirect = 500;

std::unique_ptr<StickSlipSystem> system_of(const StickSlipProblem& problem, const VectorField& guess,
                                           ContactStiffness& stiffness) {
  if ((guess.col(kDown) < 0.0).count() > kMaxDirect) return iterative_stick_slip(problem, guess);
  return direct_stick_slip(problem, guess, stiffness);
}

/// Normal forces of the same contact without friction, whose search converges from any guess. Steps of stick and slip
/// do not converge if far more nodes are guessed than are in contact: the surplus nodes then pull with thousands of
/// loads.
VectorField without_friction(const StickSlipProblem& problem, const VectorField& guess) {
  const Index half_nodes = problem.surface.half_nodes();
  const ElasticContactProblem smooth{.surface = problem.surface,
                                     .gap = as_field(problem.gap, half_nodes),
                                     .weights = as_field(problem.weights, half_nodes),
                                     .condition = {.value = problem.load}};
  ContactInverse inverse;
  VectorField force = VectorField::Zero(guess.rows(), 3);
  force.col(kDown) = -solve_elastic_contact(smooth, (-guess.col(kDown)).max(0.0), inverse).pressing;
  return force;
}

/// System with the same conditions, except that if all nodes slip, the node nearest to sticking sticks. If all nodes
/// slip in line contact, with the tractions of their own pressures, the conditions do not determine the displacement of
/// a center that forces move.
class OneSticks : public StickSlipSystem {
 public:
  explicit OneSticks(StickSlipSystem& system) : system_(system) {}

  [[nodiscard]] ConditionScales scales() const override { return system_.scales(); }
  [[nodiscard]] double load() const override { return system_.load(); }
  [[nodiscard]] Index first_node() const override { return system_.first_node(); }
  [[nodiscard]] double imbalance(const ContactSolution& state) const override { return system_.imbalance(state); }
  void find_displacements(ContactSolution& state) override { system_.find_displacements(state); }
  [[nodiscard]] int products() const override { return system_.products(); }

  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override {
    ContactSets modified = sets;
    if (modified.states.empty() || std::ranges::any_of(modified.states, &TangentialState::stick)) {
      sticking_node_ = kNone;
    } else {
      make_one_stick(modified);
    }
    system_.solve(friction, modified, tolerance, state);
  }

 private:
  static constexpr Index kNone = -1;

  /// Select the node that sticks. If the node that stuck in the last step slips again, sticking took more traction than
  /// friction allows: the other nodes move the center on, until one of those that slip in the other direction sticks.
  void make_one_stick(ContactSets& sets) {
    Eigen::Array2d exceeded(0.0, 0.0);
    const auto last = std::ranges::find(sets.contact, sticking_node_);
    if (last != sets.contact.end()) {
      exceeded = sets.states[static_cast<std::size_t>(last - sets.contact.begin())].direction;
    }
    const auto next = std::ranges::max_element(sets.states, {}, [&](const TangentialState& state) {
      return std::pair((state.direction * exceeded).sum() < 0.0, state.rigidity);
    });
    sticking_node_ = sets.contact[static_cast<std::size_t>(next - sets.states.begin())];
    *next = sticking();
  }

  StickSlipSystem& system_;
  Index sticking_node_ = kNone;
};

/// Start from forces and iterate. The first sets follow from the forces alone, because gaps and displacements are those
/// of the previous step.
/// @param[in] system system of `newton`
/// @return whether a state is found
[[nodiscard]] bool finds_from(const VectorField& force, double friction, const StickSlipSystem& system,
                              SemismoothNewton& newton) {
  ContactSolution state{.force = force,
                        .displacement = {},
                        .gap = Eigen::ArrayXd::Zero(force.rows()),
                        .contact = {},
                        .slip = Eigen::ArrayX2d::Zero(force.rows(), 2)};
  const ContactSets sets = find_sets(system, kFrictionSettings.likely_slip * friction, state);
  newton.start_from(std::move(state));
  newton.take_step(friction, sets, kFrictionSettings.exact_step);
  return newton.iterate(friction);
}

/// Start from the largest coefficient of friction, at which nearly all nodes stick, and go down to the given one: the
/// sets change little between two similar coefficients.
[[nodiscard]] bool descends_from(const VectorField& force, double friction, const StickSlipSystem& system,
                                 SemismoothNewton& newton) {
  constexpr double kLess = 0.7;  // by trial: line contacts of 20 to 100 nodes reach 0.01 and less
  double reached = kLargestFriction;
  bool is_found = finds_from(force, reached, system, newton);
  while (is_found && reached > friction) {
    reached = std::max(friction, kLess * reached);
    is_found = newton.iterate(reached);
  }
  return is_found;
}

/// If all nodes slip in line contact, their forces are the same for a range of displacements of the center, and do not
/// determine the displacement in this range. The center then stays at rest, if that is in the range. The search alone
/// would end at either end of the range, depending on round-off, and move a symmetric contact to one side.
/// @param[in,out] state,sets of a state that was found
void let_center_rest(const StickSlipProblem& problem, const StickSlipSystem& system, ContactSolution& state,
                     ContactSets& sets) {
  if (std::ranges::count_if(sets.states, &TangentialState::stick) > 1 || problem.center_row({}).displacement != 0.0)
    return;
  ContactSolution resting = state;
  resting.slip -= *state.creepage * problem.slip_per_center_displacement;
  resting.creepage = 0.0;
  ContactSets slipping = find_sets(system, problem.friction, resting);
  if (std::ranges::any_of(slipping.states, &TangentialState::stick)) return;
  if (!(resting.residual < kFrictionSettings.instant_round_off)) return;
  state = std::move(resting);
  sets = std::move(slipping);
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

double TransientStickSlipSystem::approach_scale() const {
  return 1.0 / std::max(problem_.approach.force, problem_.approach.penetration / scales_.normal);
}

double TransientStickSlipSystem::center_excess(const ContactSolution& state) const {
  return (center_.force_coefficients * state.force).sum() + center_.displacement * *state.creepage - center_.value;
}

StickSlip solve_stick_slip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness) {
  constexpr SearchLimits kLimits{.tolerance = kFrictionSettings.instant_tolerance,
                                 .round_off = kFrictionSettings.instant_round_off,
                                 .full_steps = kFrictionSettings.full_steps};
  const std::unique_ptr<StickSlipSystem> system = system_of(problem, guess, stiffness);
  OneSticks one_sticks(*system);
  SemismoothNewton plain(*system, kLimits);
  SemismoothNewton with_one_sticking(one_sticks, kLimits);
  VectorField pressing = VectorField::Zero(guess.rows(), 3);
  pressing.col(kDown) = guess.col(kDown);
  const auto found = [&]() -> const SemismoothNewton& {
    if (finds_from(guess, problem.friction, *system, plain)) return plain;
    if (finds_from(pressing, problem.friction, *system, plain)) return plain;
    const VectorField smooth = without_friction(problem, guess);
    if (finds_from(smooth, problem.friction, *system, plain)) return plain;
    if (descends_from(smooth, problem.friction, one_sticks, with_one_sticking)) {
      return with_one_sticking;
    }
    throw ConvergenceError("the stick-slip solver did not converge: friction may be too small for the drive",
                           plain.systems() + with_one_sticking.systems(), with_one_sticking.state().residual);
  };
  const SemismoothNewton& newton = found();
  ContactSolution state = newton.state();
  ContactSets sets = newton.sets();
  let_center_rest(problem, *system, state, sets);
  StickSlip result{.force = state.force,
                   .penetration = state.penetration,
                   .center_displacement = *state.creepage,
                   .slip = state.slip};
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    if (!(result.force(sets.contact[i], kDown) < 0.0)) continue;
    result.nodes.push_back(sets.contact[i]);
    result.sticking += sets.states[i].stick ? 1 : 0;
  }
  return result;
}

}  // namespace viscoroll::detail
