#include "contact/normal_contact.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "contact/dense_lu.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// An overclosure below this share of the penetration is round-off.
constexpr double kOverclosureTolerance = 1e-11;

/// Forces on the nodes in contact that flatten them all, and the penetration that balances the load.
void press_flat(const NormalContactProblem& problem, const ContactOptions& options, Watch& watch,
                ContactSolution& state) {
  const auto count = static_cast<Eigen::Index>(state.contact.size());
  Eigen::MatrixXd right_sides(count, 2);
  right_sides.col(0) = -problem.drop(state.contact).matrix();
  right_sides.col(1).setOnes();
  Eigen::MatrixXd compliance =
      problem.coating.block(state.contact, state.contact, std::array{kDown}, options.threads, watch);
  const Eigen::MatrixXd forces = solve_dense(std::move(compliance), std::move(right_sides), options.threads, watch);
  state.penetration = (problem.load - forces.col(0).sum()) / forces.col(1).sum();
  state.force.setZero();
  const Eigen::VectorXd pressing = forces.col(0) + state.penetration * forces.col(1);
  for (Eigen::Index i = 0; i < count; ++i)
    state.force(state.contact[static_cast<std::size_t>(i)], kDown) = -pressing[i];
}

bool drop_tensile(ContactSolution& state) {
  return std::erase_if(state.contact, [&](Eigen::Index node) { return !(state.force(node, kDown) < 0.0); }) > 0;
}

void find_gap(const NormalContactProblem& problem, ContactSolution& state) {
  state.displacement = problem.coating.displacement(state.force);
  state.gap = problem.drop - state.displacement.col(kDown) - state.penetration;
}

bool add_overclosed(ContactSolution& state) {
  std::vector<Eigen::Index> added;
  for (Eigen::Index node = 0; node < state.gap.size(); ++node) {
    const bool overclosed = state.gap[node] < -kOverclosureTolerance * state.penetration;
    if (overclosed && state.force(node, kDown) == 0.0) added.push_back(node);
  }
  const auto middle = static_cast<std::ptrdiff_t>(state.contact.size());
  state.contact.insert(state.contact.end(), added.begin(), added.end());
  std::inplace_merge(state.contact.begin(), state.contact.begin() + middle, state.contact.end());
  return !added.empty();
}

double largest_violation(const ContactSolution& state) {
  const double overclosure = -state.gap.minCoeff();
  const double opening = state.gap(state.contact).abs().maxCoeff();
  return std::max(overclosure, opening) / state.penetration;
}

}  // namespace

ContactSolution solve_normal_contact(const NormalContactProblem& problem, std::vector<Eigen::Index> start,
                                     const ContactOptions& options, Watch& watch) {
  ContactSolution state{.force = VectorField::Zero(problem.drop.size(), 3), .contact = std::move(start)};
  while (state.iterations < options.max_iterations && !state.converged) {
    if (static_cast<Eigen::Index>(state.contact.size()) > options.max_unknowns) {
      throw std::length_error(std::to_string(state.contact.size()) + " nodes in contact");
    }
    ++state.iterations;
    press_flat(problem, options, watch, state);
    if (drop_tensile(state)) {
      if (state.contact.empty()) throw ConvergenceError("no node carries load", state.iterations, 1.0);
      continue;
    }
    find_gap(problem, state);
    state.converged = !add_overclosed(state);
  }
  if (!state.converged) {
    state.force = state.force.min(0.0);
    find_gap(problem, state);
  }
  state.residual = largest_violation(state);
  return state;
}

}  // namespace viscoroll::detail
