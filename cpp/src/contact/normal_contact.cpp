#include "contact/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "contact/krylov.hpp"
#include "influence/fft.hpp"
#include "influence/inverse_convolution.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFirstTolerance = 1e-5;      // of relative residuals, while the set is far from the right one
constexpr double kTightening = 0.03;          // of the tolerance as the set comes closer
constexpr double kPredictionStiffness = 0.3;  // of a node's own: rather too many nodes than too few, which join last
constexpr double kOverclosureFactor = 10.0;   // overclosure that is taken for one, per tolerance
constexpr int kExchanges = 8;                 // passes in which nodes leave and join at once
constexpr double kFailure = 1e-8;             // relative residual that no answer can be built on
constexpr Index kSmallContact = 1300;         // nodes: those of the rough mesh on which windows are tried

/// Nodes pressed flat against the plane: C p = penetration - drop and sum p = load.
struct FlatPressing {
  VectorXd forces;
  double penetration;
};

/// The equations of flat pressing without their matrix. Forces come first, then the penetration times a stiffness.
///
/// The preconditioner leaves no sum of forces, so that from a guess that bears the load all steps do: what a Krylov
/// method sees is the compliance on forces without a sum, symmetric where the coating is lossless.
class FlatEquations {
 public:
  FlatEquations(const ContactProblem& problem, const InverseConvolution& inverse, const std::vector<Index>& contact)
      : problem_(problem),
        inverse_(inverse),
        contact_(contact),
        rows_(problem.surface->shape(), contact),
        count_(static_cast<Index>(contact.size())),
        stiffness_(problem.surface->normal_stiffness()),
        balance_(1.0 / std::sqrt(static_cast<double>(count_))),
        uniform_(precondition_forces(VectorXd::Ones(count_))) {}

  [[nodiscard]] VectorXd right_side() const {
    VectorXd right(count_ + 1);
    right.head(count_) = -stiffness_ * problem_.initial_gap(contact_).matrix();
    right[count_] = balance_ * problem_.normal_force;
    return right;
  }

  /// A guess whose forces bear the load.
  [[nodiscard]] VectorXd unknowns(const ContactSolution& state) const {
    VectorXd unknowns(count_ + 1);
    unknowns.head(count_) = -state.force.col(kDown)(contact_).matrix();
    unknowns[count_] = stiffness_ * state.penetration;
    VectorXd missing = VectorXd::Zero(count_ + 1);
    missing[count_] = balance_ * (problem_.normal_force - unknowns.head(count_).sum());
    return unknowns + precondition(missing);
  }

  /// What unknowns mean, with forces that bear the load to the last digit.
  [[nodiscard]] FlatPressing pressing(const VectorXd& unknowns) const {
    const double missing = problem_.normal_force - unknowns.head(count_).sum();
    return {.forces = unknowns.head(count_) + missing / uniform_.sum() * uniform_,
            .penetration = unknowns[count_] / stiffness_};
  }

  [[nodiscard]] VectorXd times(const VectorXd& unknowns) const {
    VectorXd result(count_ + 1);
    result.head(count_) = stiffness_ * problem_.surface->normal_displacement(rows_, unknowns.head(count_));
    result.head(count_).array() -= unknowns[count_];
    result[count_] = balance_ * unknowns.head(count_).sum();
    return result;
  }

  /// Solves the same equations with the inverse symbol for the inverse of C.
  [[nodiscard]] VectorXd precondition(const VectorXd& right) const {
    VectorXd result(count_ + 1);
    result.head(count_) = precondition_forces(right.head(count_));
    result[count_] = (right[count_] / balance_ - result.head(count_).sum()) / uniform_.sum();
    result.head(count_) += result[count_] * uniform_;
    return result;
  }

 private:
  [[nodiscard]] VectorXd precondition_forces(const VectorXd& right) const {
    const Execution& execution = problem_.surface->execution();
    return inverse_.apply(rows_, right / stiffness_, execution.threads, execution.watch);
  }

  const ContactProblem& problem_;
  const InverseConvolution& inverse_;
  const std::vector<Index>& contact_;
  NodeRows rows_;
  Index count_;
  double stiffness_;
  double balance_;
  VectorXd uniform_;  // forces that lower all nodes alike
};

class NormalContactSolver {
 public:
  NormalContactSolver(const ContactProblem& problem, const NormalContactGuess& guess, const ContactOptions& options)
      : problem_(problem), options_(options) {
    state_.force = VectorField::Zero(problem.initial_gap.size(), 3);
    state_.force.col(kDown) = -guess.pressing;
    state_.contact = guess.contact;
    state_.penetration = guess.penetration;
  }

  [[nodiscard]] ContactSolution solve() {
    tolerance_ = std::max(kFirstTolerance, options_.tolerance);
    if (state_.penetration > 0.0) predict_contact();
    while (state_.iterations < options_.max_iterations && !state_.converged) {
      ++state_.iterations;
      press();
      const bool rough = tolerance_ > options_.tolerance;
      const bool exchange = state_.iterations <= kExchanges;
      if (exchange) find_gap();
      std::size_t changes = drop_tensile();
      if (state_.contact.empty()) throw ConvergenceError("no node carries load", state_.iterations, 1.0);
      if (!exchange && changes == 0) find_gap();
      if (exchange || changes == 0) {
        changes += add_overclosed();
        const auto count = static_cast<double>(state_.contact.size());
        state_.converged = !rough && static_cast<double>(changes) <= options_.unsettled * count;
      }
      tolerance_ = std::max(kTightening * tolerance_, options_.tolerance);
    }
    if (!state_.converged) {
      state_.force = state_.force.min(0.0);
      find_gap();
    }
    state_.residual = largest_violation();
    return std::move(state_);
  }

 private:
  void press() {
    if (!inverse_) {
      const WindowShape shape = problem_.surface->shape();
      const WindowShape period{ComplexFft::fast_length(shape.phi_nodes), RealFft::fast_length(shape.theta_nodes)};
      const Execution& execution = problem_.surface->execution();
      inverse_ = std::make_unique<InverseConvolution>(
          shape, period, std::vector{&problem_.surface->local().table(Entry::rr)},
          std::vector<ConvolutionTerm>{{.result = 0, .table = 0, .operand = 0, .sign = 1.0}}, execution.threads,
          execution.watch);
    }
    const FlatEquations equations(problem_, *inverse_, state_.contact);
    const VectorXd right_side = equations.right_side();
    const KrylovSolution solution = solve_krylov(
        [&](const VectorXd& vector) { return equations.times(vector); },
        [&](const VectorXd& vector) { return equations.precondition(vector); }, right_side, equations.unknowns(state_),
        {.absolute = tolerance_ * right_side.norm(), .small_system = kSmallContact});
    state_.operator_applications += solution.products;
    const double error = solution.residual / right_side.norm();
    if (!(error < std::max(kFailure, 2.0 * tolerance_))) {
      throw ConvergenceError("the contact equations were not solved", state_.iterations, error);
    }
    take(equations.pressing(solution.unknowns));
  }

  /// Who touches, by the forces of the guess and the gaps that they leave.
  void predict_contact() {
    find_gap();
    const double stiffness = kPredictionStiffness * problem_.surface->normal_stiffness();
    const ArrayXd predicted = -state_.force.col(kDown) - stiffness * state_.gap;
    std::vector<Index> contact;
    for (Index node = 0; node < predicted.size(); ++node) {
      if (predicted[node] > 0.0) {
        contact.push_back(node);
      } else {
        state_.force(node, kDown) = 0.0;
      }
    }
    if (!contact.empty()) state_.contact = std::move(contact);
  }

  void take(const FlatPressing& pressing) {
    state_.penetration = pressing.penetration;
    state_.force.col(kDown).setZero();
    state_.force.col(kDown)(state_.contact) = -pressing.forces.array();
  }

  /// @return how many nodes left
  std::size_t drop_tensile() {
    const auto is_tensile = [&](Index node) { return !(state_.force(node, kDown) < 0.0); };
    for (const Index node : state_.contact) {
      if (is_tensile(node)) state_.force(node, kDown) = 0.0;
    }
    return std::erase_if(state_.contact, is_tensile);
  }

  void find_gap() {
    ++state_.operator_applications;
    const ArrayXd rise = problem_.surface->normal_displacement(-state_.force.col(kDown));
    state_.gap = problem_.initial_gap + rise - state_.penetration;
  }

  /// Those that are there already, and those that have just left, have no gap. @return how many nodes joined
  std::size_t add_overclosed() {
    const double tolerance = kOverclosureFactor * tolerance_;
    std::vector<Index> added;
    for (Index node = 0; node < state_.gap.size(); ++node) {
      const bool overclosed = state_.gap[node] < -tolerance * state_.penetration;
      if (overclosed && state_.force(node, kDown) == 0.0) added.push_back(node);
    }
    state_.contact.insert(state_.contact.end(), added.begin(), added.end());
    std::ranges::sort(state_.contact);
    return added.size();
  }

  [[nodiscard]] double largest_violation() const {
    const double overclosure = -state_.gap.minCoeff();
    const double opening = state_.gap(state_.contact).abs().maxCoeff();
    return std::max(overclosure, opening) / state_.penetration;
  }

  const ContactProblem& problem_;
  const ContactOptions& options_;
  ContactSolution state_;
  double tolerance_ = 0.0;
  std::unique_ptr<InverseConvolution> inverse_;
};

}  // namespace

ContactSolution solve_normal_contact(const ContactProblem& problem, const NormalContactGuess& guess,
                                     const ContactOptions& options) {
  return NormalContactSolver(problem, guess, options).solve();
}

}  // namespace viscoroll::detail
