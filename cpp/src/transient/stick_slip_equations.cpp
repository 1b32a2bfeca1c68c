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

constexpr double kExactness = 1e-13;  // of linear systems, as relative residuals

}  // namespace

StickSlipEquations::StickSlipEquations(const StickSlipProblem& problem, ContactStiffness& stiffness)
    : problem_(problem), stiffness_(stiffness) {
  const Index middle = problem.gap.size() / problem.tables.half_nodes() / 2 * problem.tables.half_nodes();
  own_compliance_ = problem.tables.compliance({middle}, problem.axes[kForward])(0, 0);
}

/// What follows from the nodes alone: the forces if all of them touched and stuck, by the penetration and the way.
void StickSlipEquations::cover(const std::vector<Index>& contact) {
  const bool is_new = stiffness_.cover(problem_.tables, contact);
  if (!is_new && !to_components_.empty()) return;
  to_components_.clear();
  factored_.clear();
  closed_ = Eigen::MatrixX3d::Zero(3 * static_cast<Index>(covered().size()), 3);
  Index place = 0;
  for (const Index node : covered()) {
    Eigen::Matrix3d axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t p = 0; p < 3; ++p) {
        axes(static_cast<Index>(axis), static_cast<Index>(p)) = problem_.axes[axis][p].data()[node];
      }
    }
    to_components_.emplace_back(axes.inverse());
    const double weight = problem_.weights[node];
    Eigen::Matrix3d closed;
    closed << -problem_.forward_way[node], 0.0, -weight, problem_.gap[node], -weight, 0.0, -problem_.sideways_way[node],
        0.0, 0.0;
    closed_.middleRows<3>(3 * place++) = closed;
  }
  by_closed_ = forces_by(closed_);
}

/// Forces along x, down and z by displacements along them [3 * nodes + axis].
MatrixXd StickSlipEquations::forces_by(MatrixXd displacements) const {
  const auto count = static_cast<Index>(to_components_.size());
  const auto of_node = [](MatrixXd& field, Index i) { return field.middleRows<3>(3 * i); };
  for (Index i = 0; i < count; ++i) {
    of_node(displacements, i) = (to_components_[static_cast<std::size_t>(i)] * of_node(displacements, i)).eval();
  }
  MatrixXd forces = stiffness_.matrix() * displacements;
  for (Index i = 0; i < count; ++i) {
    of_node(forces, i) = (to_components_[static_cast<std::size_t>(i)].transpose() * of_node(forces, i)).eval();
  }
  return forces;
}

StickSlipForces StickSlipEquations::solve(const std::vector<Condition>& conditions) {
  const auto free = static_cast<Index>(conditions.size());
  const Index depth = free;
  const Index way = free + 1;
  MatrixXd matrix(free + 2, free + 2);
  VectorXd right(free + 2);
  // In the components of the coating, whose stiffness it is.
  Eigen::Matrix3Xd on_force(3, free);
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    on_force.col(i) = to_components_[static_cast<std::size_t>(condition.place)] * condition.on_force;
  }
  VectorXd by_move(closed_.rows());
  for (Index column = 0; column < free; ++column) {
    const Condition& moved = conditions[static_cast<std::size_t>(column)];
    const auto direction = to_components_[static_cast<std::size_t>(moved.place)].col(moved.axis);
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
    matrix(way, row) = -by_closed_(3 * condition.place + condition.axis, 2);
  }
  // Load and center: sums of forces, weighed as `closed_` weighs displacements.
  const Eigen::Matrix3d sums = closed_.transpose() * by_closed_;
  matrix.row(depth).tail<2>() = sums.row(1).tail<2>();
  right[depth] = problem_.load - sums(1, 0);
  matrix.row(depth) *= own_compliance_;
  right[depth] *= own_compliance_;
  const CenterCondition& center = problem_.center;
  matrix.row(way).tail<2>() = -sums.row(2).tail<2>();
  matrix.row(way) *= center.force;
  matrix(way, way) += center.way;
  right[way] = center.value + center.force * sums(2, 0);
  // Forces and ways on one scale: a heavy center must not serve as pivot for anything but its own way.
  const double share = own_compliance_ / std::max(center.force, std::abs(center.way) * own_compliance_);
  matrix.row(way) *= share;
  right[way] *= share;

  const VectorXd unknowns = solved(conditions, matrix, right);
  StickSlipForces result{
      .forces = {}, .moves = VectorXd::Zero(closed_.rows()), .penetration = unknowns[depth], .way = unknowns[way]};
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    result.moves[3 * condition.place + condition.axis] = unknowns[i];
  }
  result.forces = forces_by(closed_ * Eigen::Vector3d(1.0, result.penetration, result.way) + result.moves);
  return result;
}

/// While the same displacements are free, tractions turn alone: then the last factors precondition a Krylov method.
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
