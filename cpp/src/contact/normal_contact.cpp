#include "contact/normal_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "contact/active_set.hpp"
#include "contact/krylov.hpp"
#include "influence/fft.hpp"
#include "influence/inverse_convolution.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFirstTolerance = 1e-5;  // of relative residuals, while the set is far from the right one
constexpr double kTightening = 0.03;      // of the tolerance as the set comes closer
constexpr double kFailure = 1e-8;         // relative residual that no answer can be built on
constexpr Index kSmallContact = 1300;     // nodes: those of the rough mesh on which windows are tried

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
  [[nodiscard]] VectorXd unknowns(const PressedNodes& contact) const {
    VectorXd unknowns(count_ + 1);
    unknowns.head(count_) = contact.pressing(contact_).matrix();
    unknowns[count_] = stiffness_ * *contact.penetration;
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

/// A surface whose compliance is known by its products: a Krylov method solves the systems.
class SurfaceOfProducts : public PressedSurface {
 public:
  explicit SurfaceOfProducts(const ContactProblem& problem)
      : problem_(problem), weights_(ArrayXd::Ones(problem.initial_gap.size())) {}

  void press(PressedNodes& contact, double tolerance) override {
    if (!inverse_) inverse_ = std::make_unique<InverseConvolution>(make_inverse());
    const FlatEquations equations(problem_, *inverse_, contact.nodes);
    const VectorXd right_side = equations.right_side();
    const KrylovSolution solution = solve_krylov(
        [&](const VectorXd& vector) { return equations.times(vector); },
        [&](const VectorXd& vector) { return equations.precondition(vector); }, right_side, equations.unknowns(contact),
        {.absolute = tolerance * right_side.norm(), .small_system = kSmallContact});
    products_ += solution.products;
    const double error = solution.residual / right_side.norm();
    if (!(error < std::max(kFailure, 2.0 * tolerance))) {
      throw ConvergenceError("the contact equations were not solved", contact.passes, error);
    }
    const FlatPressing pressing = equations.pressing(solution.unknowns);
    contact.penetration = pressing.penetration;
    contact.pressing.setZero();
    contact.pressing(contact.nodes) = pressing.forces.array();
  }

  [[nodiscard]] ArrayXd height(const PressedNodes& contact) override {
    ++products_;
    return problem_.initial_gap + problem_.surface->normal_displacement(contact.pressing);
  }

  [[nodiscard]] const ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return problem_.surface->normal_stiffness(); }
  [[nodiscard]] int products() const { return products_; }

 private:
  [[nodiscard]] InverseConvolution make_inverse() const {
    const WindowShape shape = problem_.surface->shape();
    const WindowShape period{ComplexFft::fast_length(shape.phi_nodes), RealFft::fast_length(shape.theta_nodes)};
    const Execution& execution = problem_.surface->execution();
    return {shape,
            period,
            std::vector{&problem_.surface->local().table(Entry::rr)},
            std::vector<ConvolutionTerm>{{.result = 0, .table = 0, .operand = 0, .sign = 1.0}},
            execution.threads,
            execution.watch};
  }

  const ContactProblem& problem_;
  ArrayXd weights_;
  int products_ = 0;
  std::unique_ptr<InverseConvolution> inverse_;
};

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

}  // namespace

ContactSolution solve_normal_contact(const ContactProblem& problem, const NormalContactGuess& guess,
                                     const ContactOptions& options) {
  SurfaceOfProducts surface(problem);
  PressedNodes contact =
      find_contact(surface, {.pressing = guess.pressing, .nodes = guess.contact, .penetration = guess.penetration},
                   {.most_passes = options.max_iterations,
                    .first_tolerance = kFirstTolerance,
                    .tightening = kTightening,
                    .tolerance = options.tolerance,
                    .unsettled = options.unsettled});
  if (!contact.converged) {
    contact.pressing = contact.pressing.max(0.0);
    contact.gap = surface.height(contact) - *contact.penetration;
  }
  return solution_of(std::move(contact), surface.products());
}

ContactSolution press_kept_nodes(const ContactProblem& problem, const NormalContactGuess& guess,
                                 const ContactOptions& options) {
  SurfaceOfProducts surface(problem);
  PressedNodes contact{.pressing = guess.pressing,
                       .nodes = guess.contact,
                       .penetration = guess.penetration,
                       .passes = 1,
                       .converged = true};
  surface.press(contact, options.tolerance);
  contact.gap = surface.height(contact) - *contact.penetration;
  return solution_of(std::move(contact), surface.products());
}

}  // namespace viscoroll::detail
