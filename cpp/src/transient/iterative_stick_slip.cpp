// Iterative solver for stick and slip at an instant, with products with the compliance.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "contact/krylov.hpp"
#include "transient/stick_slip.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Equations of the sets. All unknowns and conditions are in units of force: the forces of each node along x, down and
/// z, then the penetration and the displacement of the center, divided by the own compliance.
class ContactEquations {
 public:
  ContactEquations(const StickSlipProblem& problem, const ConditionScales& scales, double approach_scale,
                   const CenterRow& center, double friction, const ContactSets& sets)
      : problem_(problem),
        scales_(scales),
        approach_scale_(approach_scale),
        center_(center),
        friction_(friction),
        sets_(sets) {
    const double largest = center.force_coefficients.abs().maxCoeff();
    center_scale_ = 1.0 / std::max(largest, std::abs(center.displacement) / scales.tangential);
    prepare_border();
  }

  [[nodiscard]] Index size() const { return 3 * nodes() + 2; }

  /// Residual of the conditions in a state.
  [[nodiscard]] VectorXd residual(const ContactSolution& state) const {
    const VectorXd at = unknowns_of(state);
    VectorXd left(size());
    for (Index i = 0; i < nodes(); ++i) {
      const Index node = contact(i);
      const Vector3d moves(state.slip(node, 0), state.gap[node], state.slip(node, 1));
      left.segment<3>(3 * i) = conditions(i, at.segment<3>(3 * i), moves);
    }
    left.tail<2>() = sums(at);
    left[3 * nodes()] -= problem_.approach.value * approach_scale_;
    left[3 * nodes() + 1] -= center_.value * center_scale_;
    return left;
  }

  [[nodiscard]] VectorXd unknowns_of(const ContactSolution& state) const {
    VectorXd unknowns(size());
    for (Index i = 0; i < nodes(); ++i) unknowns.segment<3>(3 * i) = state.force.row(contact(i)).matrix().transpose();
    unknowns[3 * nodes()] = state.penetration * scales_.normal;
    unknowns[3 * nodes() + 1] = *state.creepage * scales_.tangential;
    return unknowns;
  }

  void add(const VectorXd& change, ContactSolution& state) const {
    const VectorXd sum = unknowns_of(state) + change;
    state.force.setZero();
    for (Index i = 0; i < nodes(); ++i) {
      state.force.row(contact(i)) = sum.segment<3>(3 * i).transpose().array();
      if (in_middle(i)) state.force(contact(i), kSideways) = 0.0;
    }
    state.penetration = sum[3 * nodes()] / scales_.normal;
    state.creepage = sum[3 * nodes() + 1] / scales_.tangential;
  }

  [[nodiscard]] VectorXd times(const VectorXd& unknowns) const {
    VectorField force = VectorField::Zero(problem_.gap.size(), 3);
    for (Index i = 0; i < nodes(); ++i) force.row(contact(i)) = unknowns.segment<3>(3 * i).transpose().array();
    const VectorField moved = problem_.surface.displacement(problem_.surface.displaced(force));
    const double penetration = unknowns[3 * nodes()] / scales_.normal;
    const double center_displacement = unknowns[3 * nodes() + 1] / scales_.tangential;
    VectorXd left(size());
    for (Index i = 0; i < nodes(); ++i) {
      const Index node = contact(i);
      const Vector3d moves(
          moved(node, kForward) + center_displacement * problem_.slip_per_center_displacement(node, 0),
          -moved(node, kDown) - penetration * problem_.weights[node],
          moved(node, kSideways) + center_displacement * problem_.slip_per_center_displacement(node, 1));
      left.segment<3>(3 * i) = conditions(i, unknowns.segment<3>(3 * i), moves);
    }
    left.tail<2>() = sums(unknowns);
    return left;
  }

  /// Approximate inverse, as if the forces of a node displaced only this node.
  [[nodiscard]] VectorXd about_inverse(const VectorXd& left) const {
    VectorXd unknowns = by_blocks(left);
    const Vector2d border = schur_.solve(left.tail<2>() - sums(unknowns));
    unknowns -= border_ * border;
    unknowns.tail<2>() = border;
    return unknowns;
  }

 private:
  [[nodiscard]] Index nodes() const { return static_cast<Index>(sets_.contact.size()); }
  [[nodiscard]] Index contact(Index i) const { return sets_.contact[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const TangentialState& what(Index i) const { return sets_.states[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool in_middle(Index i) const { return contact(i) % problem_.surface.half_nodes() == 0; }

  /// @param[in] moves slip along x, gap, slip along z
  [[nodiscard]] Vector3d conditions(Index i, const Vector3d& force, const Vector3d& moves) const {
    const auto& [stick, e, rigidity] = what(i);
    Vector3d left(scales_.tangential * moves[0], -scales_.normal * moves[1], scales_.tangential * moves[2]);
    if (!stick) {
      left[0] = e[0] * force[kForward] + friction_ * force[kDown] + e[1] * force[kSideways];
      left[2] = (1.0 - rigidity) * (e[0] * force[kSideways] - e[1] * force[kForward]) +
                rigidity * scales_.tangential * (e[0] * moves[2] - e[1] * moves[0]);
    }
    if (in_middle(i)) left[2] = force[kSideways];
    return left;
  }

  /// Conditions for load and penetration and for the center, without their values.
  [[nodiscard]] Vector2d sums(const VectorXd& unknowns) const {
    const ApproachCondition& approach = problem_.approach;
    Vector2d sums(approach.penetration * unknowns[3 * nodes()] / scales_.normal,
                  center_.displacement * unknowns[3 * nodes() + 1] / scales_.tangential);
    for (Index i = 0; i < nodes(); ++i) {
      const auto force = unknowns.segment<3>(3 * i);
      sums[0] -= approach.force * problem_.weights[contact(i)] * force[kDown];
      sums[1] += center_.force_coefficients.row(contact(i)).matrix().dot(force.transpose());
    }
    sums[0] *= approach_scale_;
    sums[1] *= center_scale_;
    return sums;
  }

  [[nodiscard]] VectorXd by_blocks(const VectorXd& left) const {
    VectorXd unknowns = VectorXd::Zero(size());
    for (Index i = 0; i < nodes(); ++i) {
      unknowns.segment<3>(3 * i) = blocks_[static_cast<std::size_t>(i)] * left.segment<3>(3 * i);
    }
    return unknowns;
  }

  void prepare_border() {
    blocks_.reserve(sets_.contact.size());
    Eigen::MatrixX2d given = Eigen::MatrixX2d::Zero(size(), 2);
    for (Index i = 0; i < nodes(); ++i) {
      Matrix3d block;
      for (Index axis = 0; axis < 3; ++axis) {
        const Vector3d force = Vector3d::Unit(axis);
        const Vector3d moves(force[kForward] / scales_.tangential, -force[kDown] / scales_.normal,
                             force[kSideways] / scales_.tangential);
        block.col(axis) = conditions(i, force, moves);
      }
      blocks_.emplace_back(block.inverse());
      const Vector3d none = Vector3d::Zero();
      const Index node = contact(i);
      given.col(0).segment<3>(3 * i) = conditions(i, none, {0.0, -problem_.weights[node] / scales_.normal, 0.0});
      given.col(1).segment<3>(3 * i) = conditions(i, none,
                                                  Vector3d(problem_.slip_per_center_displacement(node, 0), 0.0,
                                                           problem_.slip_per_center_displacement(node, 1)) /
                                                      scales_.tangential);
    }
    border_.resize(size(), 2);
    Eigen::Matrix2d schur;
    for (Index column = 0; column < 2; ++column) {
      border_.col(column) = by_blocks(given.col(column));
      schur.col(column) = -sums(border_.col(column));
    }
    schur(0, 0) += approach_scale_ * problem_.approach.penetration / scales_.normal;
    schur(1, 1) += center_scale_ * center_.displacement / scales_.tangential;
    schur_.compute(schur);
  }

  const StickSlipProblem& problem_;
  ConditionScales scales_;
  double approach_scale_;
  const CenterRow& center_;
  double friction_;
  const ContactSets& sets_;
  double center_scale_;
  std::vector<Matrix3d> blocks_;
  Eigen::MatrixX2d border_;
  Eigen::FullPivLU<Eigen::Matrix2d> schur_;
};

/// Solver of `iterative_stick_slip`.
class IterativeStickSlip final : public TransientStickSlipSystem {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] guess forces to start from
  IterativeStickSlip(const StickSlipProblem& problem, const VectorField& guess);

  [[nodiscard]] double imbalance(const ContactSolution& state) const override;
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;

 private:
  void take_off_apart(const ContactSets& sets, ContactSolution& state);
};

IterativeStickSlip::IterativeStickSlip(const StickSlipProblem& problem, const VectorField& guess)
    : TransientStickSlipSystem(problem, problem.center_row_needs_displacements ? problem.surface.displaced(guess)
                                                                               : std::vector<HalfField>()) {}

double IterativeStickSlip::imbalance(const ContactSolution& state) const {
  const ApproachCondition& approach = problem().approach;
  const double load = -(problem().weights * state.force.col(kDown)).sum();
  const double excess = approach.force * load + approach.penetration * state.penetration - approach.value;
  return std::hypot(approach_scale() * excess, center_excess(state));
}

/// Remove the forces of nodes that are no longer in contact.
void IterativeStickSlip::take_off_apart(const ContactSets& sets, ContactSolution& state) {
  VectorField force = VectorField::Zero(state.force.rows(), 3);
  force(sets.contact, Eigen::all) = state.force(sets.contact, Eigen::all);
  const bool is_known = state.displacement.rows() > 0 && (force == state.force).all();
  state.force = std::move(force);
  if (!is_known) find_displacements(state);
}

void IterativeStickSlip::solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) {
  take_off_apart(sets, state);
  const ContactEquations equations(problem(), scales(), approach_scale(), center(), friction, sets);
  const VectorXd right = -equations.residual(state);
  const KrylovSolution solution = solve_krylov([&](const VectorXd& unknowns) { return equations.times(unknowns); },
                                               [&](const VectorXd& left) { return equations.about_inverse(left); },
                                               right, VectorXd::Zero(right.size()), {.relative = tolerance}, right);
  count_products(solution.products);
  equations.add(solution.unknowns, state);
  find_displacements(state);
}

}  // namespace

std::unique_ptr<StickSlipSystem> iterative_stick_slip(const StickSlipProblem& problem, const VectorField& guess) {
  return std::make_unique<IterativeStickSlip>(problem, guess);
}

}  // namespace viscoroll::detail
