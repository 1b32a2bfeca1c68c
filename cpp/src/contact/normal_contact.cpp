#include "contact/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/validate.hpp"
#include "contact/active_set.hpp"
#include "contact/dense_pressed_surface.hpp"
#include "contact/flat_equations.hpp"
#include "contact/krylov.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFirstTolerance = 1e-5;  // relative residual while the set still changes much
constexpr double kTightening = 0.03;      // factor on the tolerance from pass to pass
// The contact of a periodic surface has many edges, and nodes leave one after the other over several passes. With the
// tolerances of other contacts, rough surfaces take a quarter more operator applications
// (python bench/rough.py 1024 --speed 1e-3).
constexpr double kFirstPeriodicTolerance = 1e-3;
constexpr double kSettlingPeriodicTolerance = 1e-7;
/// Fraction of nodes that may have joined or left since the forces of equal displacement were computed. With these
/// forces for other nodes, the solver takes as many products if few have changed, and may fail if most have.
constexpr double kSimilarity = 0.01;
constexpr double kSumChange = 0.1;     // relative change of the sum of these forces up to which they are used
constexpr Index kSmallContact = 1300;  // `small_system` of GMRES; the size of the rough mesh on which windows are tried

/// A surface whose compliance is given by operator applications; a Krylov method solves the systems.
class IterativePressedSurface : public PressedSurface {
 public:
  /// @param[in] problem contact problem
  /// @param[in] mirrored whether the contact is mirror-symmetric
  IterativePressedSurface(const ContactProblem& problem, bool mirrored)
      : problem_(problem), mirrored_(mirrored), weights_(ArrayXd::Ones(problem.initial_gap.size())) {}

  void press(PressedNodes& contact, double tolerance) override {
    if (!inverse_) inverse_ = std::make_unique<InverseConvolution>(normal_inverse(*problem_.surface));
    const bool has_forces = has_uniform(contact.nodes);
    const FlatEquations equations(problem_, *inverse_, contact.nodes, mirrored_, stiffness(),
                                  has_forces ? &uniform_ : nullptr);
    if (!has_forces) {
      uniform_ = equations.uniform();
      uniform_sum_ = uniform_.sum();
      uniform_nodes_ = contact.nodes.size();
    }
    const VectorXd right_side = equations.right_side();
    VectorXd guess = equations.unknowns(contact.pressing, *contact.penetration);
    std::optional<VectorXd> residual;
    if (contact.is_gap_current) {
      residual = equations.residual(guess, contact.gap);
    } else {
      guess = equations.corrected(std::move(guess));
    }
    const KrylovSolution solution =
        solve_krylov([&](const VectorXd& vector) { return equations.times(vector); },
                     [&](const VectorXd& vector) { return equations.precondition(vector); }, right_side, guess,
                     {.absolute = tolerance * right_side.norm(), .small_system = kSmallContact}, std::move(residual));
    products_ += solution.products;
    const double error = solution.residual / right_side.norm();
    if (!(error < std::max(kUnusableResidual, 2.0 * tolerance))) {
      throw ConvergenceError(
          "the iterative solver of the contact equations did not converge: the relative residual is " + rounded(error),
          contact.passes, error);
    }
    contact.pressing = equations.pressing(solution.unknowns);
    contact.penetration = equations.penetration(solution.unknowns);
    contact.gap_error = tolerance * right_side.norm() / stiffness();
  }

  [[nodiscard]] ArrayXd height(const PressedNodes& contact) override {
    ++products_;
    return problem_.initial_gap + problem_.surface->normal_displacement(contact.pressing, mirrored_);
  }

  [[nodiscard]] const ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return problem_.surface->normal_stiffness(); }
  [[nodiscard]] int products() const { return products_; }

 private:
  /// Whether the forces of equal displacement are known for nearly the same nodes. They must also have nearly the same
  /// sum, by which the equations divide: the nodes at the edge of a stiff shell may carry most of it.
  [[nodiscard]] bool has_uniform(const std::vector<Index>& nodes) const {
    if (uniform_nodes_ == 0) return false;
    std::size_t joined = 0;
    double sum = 0.0;
    for (const Index node : nodes) {
      if (uniform_[node] == 0.0) ++joined;
      sum += uniform_[node];
    }
    const std::size_t left = uniform_nodes_ - (nodes.size() - joined);
    const bool has_similar_sum = std::abs(sum - uniform_sum_) <= kSumChange * uniform_sum_;
    return has_similar_sum && static_cast<double>(joined + left) <= kSimilarity * static_cast<double>(nodes.size());
  }

  const ContactProblem& problem_;
  bool mirrored_;
  ArrayXd weights_;
  int products_ = 0;
  std::unique_ptr<InverseConvolution> inverse_;
  ArrayXd uniform_;  // forces that displace the nodes of an earlier pass equally
  double uniform_sum_ = 0.0;
  std::size_t uniform_nodes_ = 0;  // number of these nodes
};

/// Return the guess with forces that are their own mirror images, those of one side; nothing if the problem or the
/// contact is not symmetric.
std::optional<PressedNodes> mirrored(const ContactProblem& problem, const PressedNodes& guess) {
  if (!problem.surface->takes_mirrored() || !is_mirror_symmetric(problem)) return std::nullopt;
  const Index columns = problem.surface->shape().theta_nodes;
  std::vector<char> touches(static_cast<std::size_t>(guess.pressing.size()), 0);
  for (const Index node : guess.nodes) touches[static_cast<std::size_t>(node)] = 1;
  PressedNodes same = guess;
  for (Index start = 0; start < guess.pressing.size(); start += columns) {
    for (Index k = 0; k < columns / 2; ++k) {
      const Index node = start + columns - 1 - k;
      if (touches[static_cast<std::size_t>(node)] != touches[static_cast<std::size_t>(start + k)]) return std::nullopt;
      same.pressing[start + k] = same.pressing[node];
    }
  }
  return same;
}

double largest_violation(const PressedNodes& contact) {
  const double overclosure = -contact.gap.minCoeff();
  const double opening = contact.gap(contact.nodes).abs().maxCoeff();
  return std::max(overclosure, opening) / *contact.penetration;
}

ContactSolution solution_of(PressedNodes contact, int products) {
  ContactSolution solution;
  solution.force = VectorField::Zero(contact.pressing.size(), 3);
  solution.force.col(kDown) = -contact.pressing;
  solution.residual = largest_violation(contact);
  solution.gap = std::move(contact.gap);
  solution.contact = std::move(contact.nodes);
  solution.penetration = *contact.penetration;
  solution.iterations = contact.passes;
  solution.operator_applications = products;
  solution.converged = contact.converged;
  return solution;
}

PressedNodes start_of(const NormalContactGuess& guess) {
  return {.pressing = guess.pressing, .nodes = guess.contact, .penetration = guess.penetration};
}

/// @param[in] first_tolerance first residual, if less accurate solutions of the systems cost less
/// @param[in] settling_tolerance see `ActiveSetOptions`
template <class Surface>
ContactSolution press(Surface&& surface, PressedNodes start, const ContactOptions& options, double first_tolerance,
                      double settling_tolerance = 0.0) {
  PressedNodes contact = find_contact(surface, std::move(start),
                                      {.max_passes = options.max_iterations,
                                       .first_tolerance = first_tolerance,
                                       .tightening = kTightening,
                                       .tolerance = options.tolerance,
                                       .settling_tolerance = settling_tolerance,
                                       .unsettled = options.unsettled});
  if (!contact.converged) {
    contact.pressing = contact.pressing.max(0.0);
    contact.gap = surface.height(contact) - *contact.penetration;
  }
  return solution_of(std::move(contact), surface.products());
}

}  // namespace

ContactSolution solve_normal_contact(const ContactProblem& problem, const NormalContactGuess& guess,
                                     const ContactOptions& options) {
  PressedNodes start = start_of(guess);
  if (DensePressedSurface::is_applicable(problem, guess.contact)) {
    return press(DensePressedSurface(problem), std::move(start), options, options.tolerance);
  }
  if (std::optional<PressedNodes> same = mirrored(problem, start)) {
    return press(IterativePressedSurface(problem, true), *std::move(same), options, kFirstTolerance);
  }
  IterativePressedSurface surface(problem, false);
  if (!problem.surface->period()) return press(surface, std::move(start), options, kFirstTolerance);
  return press(surface, std::move(start), options, kFirstPeriodicTolerance, kSettlingPeriodicTolerance);
}

ContactSolution solve_given_nodes(const ContactProblem& problem, const NormalContactGuess& guess,
                                  const ContactOptions& options) {
  const PressedNodes start = start_of(guess);
  const std::optional<PressedNodes> same = mirrored(problem, start);
  IterativePressedSurface surface(problem, same.has_value());
  PressedNodes contact = same.value_or(start);
  contact.passes = 1;
  contact.converged = true;
  surface.press(contact, options.tolerance);
  contact.gap = surface.height(contact) - *contact.penetration;
  return solution_of(std::move(contact), surface.products());
}

}  // namespace viscoroll::detail
