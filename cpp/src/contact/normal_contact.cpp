#include "contact/normal_contact.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "contact/dense_lu.hpp"
#include "contact/krylov.hpp"
#include "influence/inverse_convolution.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// An overclosure below this share of the penetration is round-off, or what a Krylov solution leaves.
constexpr double kOverclosureTolerance = 1e-11;
constexpr double kKrylovOverclosureTolerance = 1e-9;

/// Up to here elimination is quick, and exact to round-off.
constexpr std::size_t kMostDenseNodes = 600;

constexpr double kKrylovTolerance = 1e-11;  // of relative residuals
constexpr double kKrylovFailure = 1e-9;     // relative residual that no answer can be built on

/// Press the nodes in contact flat against the plane, in its old position and for a unit of penetration.
struct FlatForces {
  Eigen::VectorXd at_rest;
  Eigen::VectorXd per_penetration;
};

FlatForces press_by_elimination(const NormalContactProblem& problem, const ContactOptions& options, Watch& watch,
                                const ContactSolution& state) {
  const auto count = static_cast<Eigen::Index>(state.contact.size());
  Eigen::MatrixXd right_sides(count, 2);
  right_sides.col(0) = (state.penetration - problem.drop(state.contact)).matrix();
  right_sides.col(1).setOnes();
  Eigen::MatrixXd compliance =
      problem.coating.block(state.contact, state.contact, std::array{kDown}, options.threads, watch);
  const Eigen::MatrixXd forces = solve_dense(std::move(compliance), std::move(right_sides), options.threads, watch);
  return {.at_rest = forces.col(0), .per_penetration = forces.col(1)};
}

/// The same by products, unless the Krylov method fails: memory so strong that the symbol is far from the matrix.
std::optional<FlatForces> press_by_products(const NormalContactProblem& problem,
                                            const InverseConvolution& preconditioner, Watch& watch,
                                            const ContactSolution& state) {
  const auto solve = [&](const Eigen::VectorXd& lowering, const Eigen::VectorXd& guess) {
    return solve_krylov(problem.coating, preconditioner, state.contact, lowering, guess, kKrylovTolerance, watch);
  };
  const Eigen::VectorXd lowering = (state.penetration - problem.drop(state.contact)).matrix();
  KrylovSolution at_rest = solve(lowering, pressing_force(state)(state.contact).matrix());
  if (!(at_rest.error < kKrylovFailure)) return std::nullopt;
  const Eigen::Index count = lowering.size();
  KrylovSolution per_penetration = solve(Eigen::VectorXd::Ones(count), Eigen::VectorXd::Zero(count));
  if (!(per_penetration.error < kKrylovFailure)) return std::nullopt;
  return FlatForces{.at_rest = std::move(at_rest.forces), .per_penetration = std::move(per_penetration.forces)};
}

/// Presses contacts of all sizes.
class Press {
 public:
  Press(const NormalContactProblem& problem, const ContactOptions& options, Watch& watch)
      : problem_(problem), options_(options), watch_(watch) {}

  [[nodiscard]] FlatForces operator()(const ContactSolution& state) {
    if (by_products_ && state.contact.size() > kMostDenseNodes) {
      if (!preconditioner_) preconditioner_.emplace(problem_.coating.shape(), problem_.coating.radial_table());
      if (auto forces = press_by_products(problem_, *preconditioner_, watch_, state)) return *std::move(forces);
      by_products_ = false;
    }
    if (static_cast<Eigen::Index>(state.contact.size()) > options_.max_unknowns) {
      throw std::length_error(std::to_string(state.contact.size()) + " nodes in contact, for elimination alone");
    }
    return press_by_elimination(problem_, options_, watch_, state);
  }

 private:
  const NormalContactProblem& problem_;
  const ContactOptions& options_;
  Watch& watch_;
  bool by_products_ = true;
  std::optional<InverseConvolution> preconditioner_;
};

/// The penetration that balances the load.
void balance(const FlatForces& forces, double load, ContactSolution& state) {
  const double more = (load - forces.at_rest.sum()) / forces.per_penetration.sum();
  const Eigen::VectorXd pressing = forces.at_rest + more * forces.per_penetration;
  state.penetration += more;
  state.force.setZero();
  for (std::size_t i = 0; i < state.contact.size(); ++i) {
    state.force(state.contact[i], kDown) = -pressing[static_cast<Eigen::Index>(i)];
  }
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
  const double tolerance =
      state.contact.size() <= kMostDenseNodes ? kOverclosureTolerance : kKrylovOverclosureTolerance;
  for (Eigen::Index node = 0; node < state.gap.size(); ++node) {
    const bool overclosed = state.gap[node] < -tolerance * state.penetration;
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
  Press press(problem, options, watch);
  while (state.iterations < options.max_iterations && !state.converged) {
    ++state.iterations;
    balance(press(state), problem.load, state);
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
