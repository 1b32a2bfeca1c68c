#include "contact/frozen_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/validate.hpp"
#include "contact/normal_contact.hpp"
#include "contact/stick_slip_by_products.hpp"
#include "contact/stick_slip_conditions.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// Largest number of Newton steps. The start is nearby and only the directions of slip are nonlinear in the forces.
constexpr int kMaxSteps = 12;
constexpr double kSettledChange = 1e-11;  // change of the forces in a step that ends the iteration, per load
constexpr double kUnsettled = 1e-6;       // change in the last step above which the iteration has failed, per load
constexpr double kExactStep = 1e-11;      // residual of the linear system of a step

ContactSets sets_of(const StickSlipSystem& system, double friction, const std::vector<char>& sticks,
                    const ContactSolution& state) {
  ContactSets sets{.contact = state.contact, .states = {}};
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    sets.states.push_back(sticks[i] != 0 ? sticking() : slipping(system, friction, state, sets.contact[i]));
  }
  return sets;
}

ContactSolution slide_kept_nodes(const ContactProblem& problem, ContactSolution state) {
  const double friction = problem.friction->coefficient;
  StickSlipByProducts system(problem);
  std::vector<char> sticks(state.contact.size());
  std::ranges::transform(state.contact, sticks.begin(),
                         [&](Index node) { return std::ranges::binary_search(state.stick, node) ? 1 : 0; });
  if (const auto given = problem.friction->drive->given_creepage()) state.creepage = given;
  system.find_displacements(state);
  double change = 1.0;
  for (int step = 0; step < kMaxSteps && change > kSettledChange; ++step) {
    const VectorField before = state.force;
    system.solve(friction, sets_of(system, friction, sticks, state), kExactStep, state);
    change = (state.force - before).matrix().norm() / problem.normal_force;
    ++state.iterations;
  }
  if (!(change < kUnsettled))
    throw ConvergenceError(
        "the iteration with the given nodes in contact did not converge: the last step changed the forces by " +
            rounded(change) + " of the load",
        state.iterations, change);
  state.operator_applications = system.products();
  state.residual = change;
  state.converged = true;
  return state;
}

}  // namespace

ContactSolution solve_frozen_contact(const ContactProblem& problem, ContactSolution kept,
                                     const ContactOptions& options) {
  if (problem.friction) {
    ContactProblem scaled = problem;
    scale_by(kept, scaled);
    return slide_kept_nodes(scaled, std::move(kept));
  }
  return solve_given_nodes(
      problem, {.contact = kept.contact, .pressing = pressing_force(kept), .penetration = kept.penetration}, options);
}

}  // namespace viscoroll::detail
