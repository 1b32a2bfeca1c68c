#include "contact/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "base/validate.hpp"
#include "contact/active_set.hpp"
#include "contact/dense_pressed_surface.hpp"
#include "contact/krylov.hpp"
#include "influence/fft.hpp"
#include "influence/table_product.hpp"
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
constexpr Index kSmallContact = 1300;  // `small_system` of GMRES; the size of the rough mesh on which windows are tried

/// Equations of frictionless contact, without their matrix. Forces come first, then the penetration times a stiffness.
/// The last equation is the condition on the load or on the penetration.
///
/// If the contact is mirror-symmetric, one node represents itself and its image, and its unknown is the force times
/// sqrt(2). Sums of squares are then those of all nodes, and so is every step of a Krylov method.
///
/// The preconditioner satisfies the last equation, and so does every step from a guess that satisfies it. At a given
/// load the forces of a step sum to zero: a Krylov method meets the compliance restricted to such forces, which is
/// symmetric if the coating is lossless. At a given penetration the last unknown does not change, and the equation
/// drops out.
class FlatEquations {
 public:
  FlatEquations(const ContactProblem& problem, const InverseConvolution& inverse, const std::vector<Index>& contact,
                bool mirrored)
      : problem_(problem),
        inverse_(inverse),
        rows_(problem.surface->shape(), contact, mirrored),
        count_(rows_.count()),
        roots_(VectorXd::Ones(count_)),
        stiffness_(problem.surface->normal_stiffness()),
        condition_(problem.normal_condition(stiffness_)),
        balance_(1.0 / std::sqrt(static_cast<double>(contact.size()))) {
    if (mirrored) {
      for_nodes([&](Index i, Index k) { roots_[i] = k > 0 ? std::numbers::sqrt2 : 1.0; });
    }
    uniform_ = precondition_forces(roots_);
  }

  [[nodiscard]] VectorXd right_side() const {
    VectorXd right(count_ + 1);
    for (Index i = 0; i < count_; ++i) right[i] = -stiffness_ * roots_[i] * problem_.initial_gap[rows_.node(i)];
    right[count_] = balance_ * condition_.value;
    return right;
  }

  /// Return the unknowns of a guess, corrected so that they satisfy the last equation.
  [[nodiscard]] VectorXd unknowns(const PressedNodes& contact) const {
    VectorXd unknowns(count_ + 1);
    for (Index i = 0; i < count_; ++i) unknowns[i] = roots_[i] * contact.pressing[rows_.node(i)];
    unknowns[count_] = stiffness_ * *contact.penetration;
    const double lowering = (condition_.value - conditioned(unknowns)) / response();
    unknowns.head(count_) += lowering * uniform_;
    unknowns[count_] += lowering;
    return unknowns;
  }

  /// Store the solution in `contact`, with forces corrected so that the last equation holds to the last digit.
  void press(const VectorXd& unknowns, PressedNodes& contact) const {
    const double missing = condition_.value - conditioned(unknowns);
    const VectorXd forces = (unknowns.head(count_) + missing / response() * uniform_).cwiseQuotient(roots_);
    contact.penetration = problem_.penetration.value_or(unknowns[count_] / stiffness_);
    contact.pressing.setZero();
    for_nodes([&](Index i, Index k) {
      contact.pressing[rows_.node(i)] = forces[i];
      if (rows_.mirrored()) contact.pressing[rows_.node(i) - 2 * k] = forces[i];
    });
  }

  [[nodiscard]] VectorXd times(const VectorXd& unknowns) const {
    scaled_ = unknowns.head(count_).cwiseQuotient(roots_);
    scaled_ = problem_.surface->normal_displacement(rows_, scaled_);
    VectorXd result(count_ + 1);
    result.head(count_) = roots_.cwiseProduct(stiffness_ * scaled_);
    result.head(count_) -= unknowns[count_] * roots_;
    result[count_] = balance_ * conditioned(unknowns);
    return result;
  }

  /// Solve the same equations with the inverse symbol instead of the inverse of C.
  [[nodiscard]] VectorXd precondition(const VectorXd& right) const {
    VectorXd result(count_ + 1);
    result.head(count_) = precondition_forces(right.head(count_));
    result[count_] = (right[count_] / balance_ - condition_.per_force * sum(result)) / response();
    result.head(count_) += result[count_] * uniform_;
    return result;
  }

 private:
  template <class Function>
  void for_nodes(const Function& function) const {
    for (int row = 0; row < rows_.rows(); ++row) rows_.for_row(row, function);
  }

  /// Sum of the forces of all nodes.
  [[nodiscard]] double sum(const VectorXd& unknowns) const { return roots_.dot(unknowns.head(count_)); }

  /// Left side of the last equation.
  [[nodiscard]] double conditioned(const VectorXd& unknowns) const {
    return condition_.per_force * sum(unknowns) + condition_.per_penetration * unknowns[count_];
  }

  /// Change of this side if all nodes are lowered by the same amount.
  [[nodiscard]] double response() const { return condition_.per_force * sum(uniform_) + condition_.per_penetration; }

  [[nodiscard]] VectorXd precondition_forces(const Eigen::Ref<const VectorXd>& right) const {
    const Execution& execution = problem_.surface->execution();
    scaled_ = right.cwiseQuotient(stiffness_ * roots_);
    VectorXd forces = inverse_.apply(rows_, scaled_, execution.threads, execution.watch);
    forces = roots_.cwiseProduct(forces);
    return forces;
  }

  const ContactProblem& problem_;
  const InverseConvolution& inverse_;
  NodeRows rows_;
  Index count_;
  VectorXd roots_;  // square root of the number of nodes that an unknown represents
  double stiffness_;
  NormalCondition condition_;
  double balance_;
  VectorXd uniform_;         // forces that lower all nodes by the same amount
  mutable VectorXd scaled_;  // operand of the products; freeing and allocating its memory costs more than the product
};

/// A surface whose compliance is given by operator applications; a Krylov method solves the systems.
class IterativePressedSurface : public PressedSurface {
 public:
  /// @param[in] problem contact problem
  /// @param[in] mirrored whether the contact is mirror-symmetric
  IterativePressedSurface(const ContactProblem& problem, bool mirrored)
      : problem_(problem), mirrored_(mirrored), weights_(ArrayXd::Ones(problem.initial_gap.size())) {}

  void press(PressedNodes& contact, double tolerance) override {
    if (!inverse_) inverse_ = std::make_unique<InverseConvolution>(make_inverse());
    const FlatEquations equations(problem_, *inverse_, contact.nodes, mirrored_);
    const VectorXd right_side = equations.right_side();
    const KrylovSolution solution = solve_krylov(
        [&](const VectorXd& vector) { return equations.times(vector); },
        [&](const VectorXd& vector) { return equations.precondition(vector); }, right_side, equations.unknowns(contact),
        {.absolute = tolerance * right_side.norm(), .small_system = kSmallContact});
    products_ += solution.products;
    const double error = solution.residual / right_side.norm();
    if (!(error < std::max(kUnusableResidual, 2.0 * tolerance))) {
      throw ConvergenceError(
          "the iterative solver of the contact equations did not converge: the relative residual is " + rounded(error),
          contact.passes, error);
    }
    equations.press(solution.unknowns, contact);
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
  [[nodiscard]] InverseConvolution make_inverse() const {
    const WindowShape shape = problem_.surface->shape();
    const WindowShape period = problem_.surface->period().value_or(
        WindowShape{RealFft::fast_length(shape.phi_nodes), RealFft::fast_length(shape.theta_nodes)});
    const Execution& execution = problem_.surface->execution();
    return {shape,
            period,
            std::vector{&problem_.surface->local().table(Entry::rr)},
            std::vector<ConvolutionTerm>{{.result = 0, .table = 0, .operand = 0, .sign = 1.0}},
            execution.threads,
            execution.watch};
  }

  const ContactProblem& problem_;
  bool mirrored_;
  ArrayXd weights_;
  int products_ = 0;
  std::unique_ptr<InverseConvolution> inverse_;
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
