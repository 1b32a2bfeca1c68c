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

StickSlipEquations::StickSlipEquations(const StickSlipProblem& problem, double own_compliance,
                                       ContactStiffness& stiffness)
    : problem_(problem),
      stiffness_(stiffness),
      own_compliance_(own_compliance),
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
  close();
  weigh_center();
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
    closed_.col(0).segment<3>(3 * place++) << -known_slip_(node, 0), gap_[node], -known_slip_(node, 1);
  }
  by_closed_.col(0) = forces_by(closed_.col(0));
}

void StickSlipEquations::close() {
  closed_ = Eigen::MatrixX3d::Zero(3 * static_cast<Index>(covered().size()), 3);
  Index place = 0;
  for (const Index node : covered()) {
    const auto& by_center = problem_.by_center;
    Eigen::Matrix3d closed;
    closed << -known_slip_(node, 0), 0.0, -by_center(node, 0),  //
        gap_[node], -problem_.weights[node], 0.0,               //
        -known_slip_(node, 1), 0.0, -by_center(node, 1);
    closed_.middleRows<3>(3 * place++) = closed;
  }
  by_closed_ = forces_by(closed_);
}

void StickSlipEquations::drive(CenterRow row) {
  center_ = std::move(row);
  if (!to_frame_.empty()) weigh_center();
}

void StickSlipEquations::weigh_center() {
  VectorXd row(closed_.rows());
  Index place = 0;
  for (const Index node : covered()) row.segment<3>(3 * place++) = center_.on_force.row(node).transpose();
  by_center_ = forces_by(row);
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
  Eigen::Matrix3Xd on_force(3, free);
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    on_force.col(i) = to_frame_[static_cast<std::size_t>(condition.place)] * condition.on_force;
  }
  VectorXd by_move(closed_.rows());
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
      matrix(row, column) = on_force.col(row).dot(by_move.segment<3>(3 * condition.place));
      if (condition.place == moved.place) matrix(row, column) += condition.on_move[moved.axis];
    }
  }
  for (Index row = 0; row < free; ++row) {
    const Condition& condition = conditions[static_cast<std::size_t>(row)];
    const Eigen::RowVector3d given = condition.on_force.transpose() * by_closed_.middleRows<3>(3 * condition.place);
    right[row] = -given[0];
    matrix.row(row).tail<2>() = given.tail<2>();
    matrix(depth, row) = by_closed_(3 * condition.place + condition.axis, 1);
    matrix(center, row) = by_center_[3 * condition.place + condition.axis];
  }
  // Rows of load and center: sums of forces, with the weights that `closed_` and the row of the center give
  // displacements.
  const Eigen::RowVector3d pressing = closed_.col(1).transpose() * by_closed_;
  matrix.row(depth).tail<2>() = pressing.tail<2>();
  right[depth] = problem_.load - pressing[0];
  matrix.row(depth) *= own_compliance_;
  right[depth] *= own_compliance_;
  const Eigen::RowVector3d of_center = by_center_.transpose() * closed_;
  matrix.row(center).tail<2>() = of_center.tail<2>();
  matrix(center, center) += center_.displacement;
  right[center] = center_.value - of_center[0];
  // Scale forces and displacements equally: a heavy center must be the pivot of its own displacement only.
  const double largest = center_.on_force.abs().maxCoeff();
  const double share = own_compliance_ / std::max(largest, std::abs(center_.displacement) * own_compliance_);
  matrix.row(center) *= share;
  right[center] *= share;

  const VectorXd unknowns = solved(conditions, matrix, right);
  StickSlipForces result{.forces = {},
                         .moves = VectorXd::Zero(closed_.rows()),
                         .penetration = unknowns[depth],
                         .center_displacement = unknowns[center]};
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    result.moves[3 * condition.place + condition.axis] = unknowns[i];
  }
  result.forces =
      forces_by(closed_ * Eigen::Vector3d(1.0, result.penetration, result.center_displacement) + result.moves);
  return result;
}

/// Solve a system. If the same displacements are free as before, only tractions turn, and the last factors precondition
/// a Krylov method.
VectorXd StickSlipEquations::solved(const std::vector<Condition>& conditions, const MatrixXd& matrix,
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
