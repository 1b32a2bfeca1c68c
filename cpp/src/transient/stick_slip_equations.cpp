#include "transient/stick_slip_equations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contact/krylov.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kExactness = 1e-13;  // relative residual of linear systems

constexpr Index kColumns = 100;  // of the largest systems between two checkpoints; some milliseconds

}  // namespace

StickSlipEquations::StickSlipEquations(const StickSlipProblem& problem, double tangential_compliance,
                                       ContactStiffness& stiffness)
    : problem_(problem),
      stiffness_(stiffness),
      tangential_compliance_(tangential_compliance),
      gap_(problem.gap),
      known_slip_(problem.known_slip) {}

/// Compute quantities that depend on the nodes only: the forces if all of them touched and stuck, as functions of the
/// penetration and the displacement of the center.
void StickSlipEquations::cover(const std::vector<Index>& contact) {
  const bool is_new = stiffness_.cover(problem_.surface, contact);
  if (!is_new && !to_frame_.empty()) return;
  to_frame_.clear();
  factored_.clear();
  for (const Index node : covered()) to_frame_.push_back(problem_.surface.to_frame(node));
  set_sticking_state();
  set_center_row();
}

void StickSlipEquations::correct(const std::vector<Index>& nodes, const Eigen::ArrayXd& gap,
                                 const Eigen::ArrayX2d& slip) {
  for (const Index node : nodes) {
    gap_[node] += gap[node];
    known_slip_.row(node) += slip.row(node);
  }
  if (to_frame_.empty()) return;
  Index place = 0;
  for (const Index node : covered()) {
    sticking_displacements_.col(0).segment<3>(3 * place++) << -known_slip_(node, 0), gap_[node], -known_slip_(node, 1);
  }
  sticking_forces_.col(0) = forces_by(sticking_displacements_.col(0));
}

void StickSlipEquations::set_sticking_state() {
  sticking_displacements_ = Eigen::MatrixX3d::Zero(3 * static_cast<Index>(covered().size()), 3);
  Index place = 0;
  for (const Index node : covered()) {
    const auto& slip_per_center_displacement = problem_.slip_per_center_displacement;
    Eigen::Matrix3d displacements;
    displacements << -known_slip_(node, 0), 0.0, -slip_per_center_displacement(node, 0),  //
        gap_[node], -problem_.weights[node], 0.0,                                         //
        -known_slip_(node, 1), 0.0, -slip_per_center_displacement(node, 1);
    sticking_displacements_.middleRows<3>(3 * place++) = displacements;
  }
  sticking_forces_ = forces_by(sticking_displacements_);
}

void StickSlipEquations::set_center_condition(CenterRow row) {
  center_ = std::move(row);
  if (!to_frame_.empty()) set_center_row();
}

void StickSlipEquations::set_center_row() {
  VectorXd row(sticking_displacements_.rows());
  Index place = 0;
  for (const Index node : covered()) row.segment<3>(3 * place++) = center_.force_coefficients.row(node).transpose();
  center_row_ = forces_by(row);
}

/// Forces along x, down and z for displacements along them [3 * nodes + axis].
MatrixXd StickSlipEquations::forces_by(MatrixXd displacements) const {
  const auto count = static_cast<Index>(to_frame_.size());
  const auto of_node = [](MatrixXd& field, Index i) { return field.middleRows<3>(3 * i); };
  for (Index i = 0; i < count; ++i) {
    of_node(displacements, i) = (to_frame_[static_cast<std::size_t>(i)] * of_node(displacements, i)).eval();
  }
  MatrixXd forces = stiffness_.matrix() * displacements;
  for (Index i = 0; i < count; ++i) {
    of_node(forces, i) = (to_frame_[static_cast<std::size_t>(i)].transpose() * of_node(forces, i)).eval();
  }
  return forces;
}

StickSlipForces StickSlipEquations::solve(const std::vector<Condition>& conditions) {
  const auto free = static_cast<Index>(conditions.size());
  const Index depth = free;
  const Index center = free + 1;
  MatrixXd matrix(free + 2, free + 2);
  VectorXd right(free + 2);
  // In the frame of the stiffness.
  Eigen::Matrix3Xd force_coefficients(3, free);
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    force_coefficients.col(i) = to_frame_[static_cast<std::size_t>(condition.place)] * condition.force_coefficients;
  }
  VectorXd by_move(sticking_displacements_.rows());
  for (Index column = 0; column < free; ++column) {
    if (column % kColumns == 0) problem_.surface.checkpoint();
    const Condition& moved = conditions[static_cast<std::size_t>(column)];
    const auto direction = to_frame_[static_cast<std::size_t>(moved.place)].col(moved.axis);
    by_move.setZero();
    for (Index p = 0; p < 3; ++p) {
      if (direction[p] != 0.0) by_move += direction[p] * stiffness_.matrix().col(3 * moved.place + p);
    }
    for (Index row = 0; row < free; ++row) {
      const Condition& condition = conditions[static_cast<std::size_t>(row)];
      matrix(row, column) = force_coefficients.col(row).dot(by_move.segment<3>(3 * condition.place));
      if (condition.place == moved.place) matrix(row, column) += condition.displacement_coefficients[moved.axis];
    }
  }
  for (Index row = 0; row < free; ++row) {
    const Condition& condition = conditions[static_cast<std::size_t>(row)];
    const Eigen::RowVector3d given =
        condition.force_coefficients.transpose() * sticking_forces_.middleRows<3>(3 * condition.place);
    right[row] = -given[0];
    matrix.row(row).tail<2>() = given.tail<2>();
    matrix(depth, row) = sticking_forces_(3 * condition.place + condition.axis, 1);
    matrix(center, row) = center_row_[3 * condition.place + condition.axis];
  }
  // Rows of load and center: sums of forces, with the weights that `sticking_displacements_` and the row of the center
  // give displacements.
  const Eigen::RowVector3d pressing = sticking_displacements_.col(1).transpose() * sticking_forces_;
  matrix.row(depth).tail<2>() = pressing.tail<2>();
  right[depth] = problem_.load - pressing[0];
  matrix.row(depth) *= tangential_compliance_;
  right[depth] *= tangential_compliance_;
  const Eigen::RowVector3d of_center = center_row_.transpose() * sticking_displacements_;
  matrix.row(center).tail<2>() = of_center.tail<2>();
  matrix(center, center) += center_.displacement;
  right[center] = center_.value - of_center[0];
  // Scale forces and displacements equally: a heavy center must be the pivot of its own displacement only.
  const double largest = center_.force_coefficients.abs().maxCoeff();
  const double share =
      tangential_compliance_ / std::max(largest, std::abs(center_.displacement) * tangential_compliance_);
  matrix.row(center) *= share;
  right[center] *= share;

  const VectorXd unknowns = solve_system(conditions, matrix, right);
  StickSlipForces result{.forces = {},
                         .free_displacements = VectorXd::Zero(sticking_displacements_.rows()),
                         .penetration = unknowns[depth],
                         .center_displacement = unknowns[center]};
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    result.free_displacements[3 * condition.place + condition.axis] = unknowns[i];
  }
  result.forces =
      forces_by(sticking_displacements_ * Eigen::Vector3d(1.0, result.penetration, result.center_displacement) +
                result.free_displacements);
  return result;
}

/// Solve a system. If the same displacements are free as before, only tractions turn, and the last factors precondition
/// a Krylov method.
VectorXd StickSlipEquations::solve_system(const std::vector<Condition>& conditions, const MatrixXd& matrix,
                                          const VectorXd& right) {
  std::vector<std::pair<Index, Axis>> free;
  free.reserve(conditions.size());
  for (const Condition& condition : conditions) free.emplace_back(condition.place, condition.axis);
  if (!free.empty() && free == factored_) {
    const double small = kExactness * right.norm();
    const KrylovSolution solution =
        solve_krylov([&](const VectorXd& vector) -> VectorXd { return matrix * vector; },
                     [&](const VectorXd& vector) -> VectorXd { return factors_.solve(vector); }, right,
                     factors_.solve(right), {.absolute = small});
    if (solution.residual <= small) return solution.unknowns;
  }
  factored_ = std::move(free);
  factors_.compute(matrix);
  return factors_.solve(right);
}

}  // namespace viscoroll::detail
