/// @file
/// @brief Dense contact equations from unit forces, as a reference for iterative solutions.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/dense_solvers.hpp"
#include "contact/contact_problem.hpp"
#include "contact/stick_slip_system.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::oracle {

using Eigen::Index;

/// Displacements due to unit forces, with [axis * nodes + node] as row and column.
inline Eigen::MatrixXd compliance(const detail::SurfaceOperator& surface, bool tangential = true) {
  const Index nodes = surface.shape().size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
  for (Index axis = 0; axis < 3; ++axis) {
    if (!tangential && axis != detail::kDown) continue;
    for (Index node = 0; node < nodes; ++node) {
      detail::VectorField force = detail::VectorField::Zero(nodes, 3);
      force(node, axis) = 1.0;
      matrix.col(axis * nodes + node) = surface.displacement(force).matrix().reshaped();
    }
  }
  return matrix;
}

/// Forces on a set of nodes that are in contact with the plane, followed by the penetration.
inline Eigen::VectorXd press_flat(const detail::ContactProblem& problem, const Eigen::MatrixXd& compliance,
                                  const std::vector<Index>& contact) {
  const Index nodes = problem.initial_gap.size();
  const auto count = static_cast<Index>(contact.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + 1, count + 1);
  matrix.topLeftCorner(count, count) = compliance.block(nodes, nodes, nodes, nodes)(contact, contact);
  matrix.col(count).head(count).setConstant(-1.0);
  matrix.row(count).head(count).setOnes();
  Eigen::VectorXd right(count + 1);
  right << -problem.initial_gap(contact).matrix(), problem.normal_force;
  return detail::dense_inverse(matrix) * right;
}

/// One Newton step with the forces of all nodes as unknowns: column by column, then penetration and creepage.
inline Eigen::VectorXd newton_step(const detail::ContactProblem& problem, const Eigen::MatrixXd& compliance,
                                   const detail::ConditionScales& scales, const detail::ContactSets& sets,
                                   const detail::ContactSolution& state) {
  const detail::Friction& friction = *problem.friction;
  const Index nodes = problem.initial_gap.size();
  const Index stride = problem.surface->shape().theta_nodes;
  const Index penetration = 3 * nodes;
  const Index creepage = penetration + 1;
  const detail::VectorField& passed = state.counterbody_displacement;
  Eigen::MatrixXd matrix =
      // Rows that are not set below mean zero force.
      Eigen::MatrixXd::Identity(creepage + 1, creepage + 1);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(creepage + 1);
  const auto force = [&](Index node, Index axis) { return axis * nodes + node; };
  // Add the slip S along an axis, times a factor, to a row of the system.
  const auto add_slip = [&](Index row, Index node, Index column, double factor) {
    const Index axis = column == 0 ? detail::kForward : detail::kSideways;
    // Only one body of the pair deforms here; the material of a counterbody passes 1 + c times as fast.
    const double pace = passed.rows() > 0 ? 1.0 + *state.creepage : 1.0;
    matrix.row(row).head(penetration) +=
        factor * pace * (compliance.row(force(node, axis)) - compliance.row(force(node - stride, axis)));
    matrix(row, creepage) += factor * friction.counterbody_rigid_displacement(node, column);
    right[row] -= factor * friction.rigid_slip(node, column);
    if (passed.rows() > 0) {
      const double increment = passed(node, axis) - passed(node - stride, axis);
      matrix(row, creepage) += factor * increment;
      right[row] += factor * *state.creepage * increment;
    }
  };
  for (std::size_t i = 0; i < sets.contact.size(); ++i) {
    const Index node = sets.contact[i];
    const detail::TangentialState& does = sets.states[i];
    const Index down = force(node, detail::kDown);
    matrix.row(down).head(penetration) = compliance.row(down);
    matrix(down, penetration) = 1.0;
    right[down] = problem.initial_gap[node];
    const Index along = force(node, detail::kForward);
    const Index aside = force(node, detail::kSideways);
    matrix.row(along).setZero();
    matrix.row(aside).setZero();
    if (does.stick) {
      add_slip(along, node, 0, 1.0);
      add_slip(aside, node, 1, 1.0);
      continue;
    }
    const Eigen::Array2d e = does.direction;
    matrix(along, along) = e[0];
    matrix(along, aside) = e[1];
    matrix(along, down) = friction.coefficient;  // F_y = -p
    matrix(aside, along) = -(1.0 - does.rigidity) * e[1];
    matrix(aside, aside) = (1.0 - does.rigidity) * e[0];
    add_slip(aside, node, 0, -does.rigidity * scales.tangential * e[1]);
    add_slip(aside, node, 1, does.rigidity * scales.tangential * e[0]);
  }
  matrix.row(penetration).setZero();
  for (Index node = 0; node < nodes; ++node) matrix(penetration, force(node, detail::kDown)) = -1.0;
  right[penetration] = problem.normal_force;
  const detail::DriveRow drive =
      friction.drive->row({*problem.surface, friction.arms, state.force, own_displacement(state)}, 1.0);
  matrix.row(creepage).setZero();
  matrix.row(creepage).head(penetration) = drive.force_coefficients.matrix().reshaped().transpose();
  if (drive.displacement_coefficients.rows() > 0) {
    matrix.row(creepage).head(penetration) +=
        drive.displacement_coefficients.matrix().reshaped().transpose() * compliance;
  }
  matrix(creepage, creepage) = drive.creepage_coefficient;
  right[creepage] = drive.value;
  // Displacements are about 1e-6 of forces, so rows are scaled to equal size.
  for (Index row = 0; row <= creepage; ++row) {
    const double size = matrix.row(row).cwiseAbs().maxCoeff();
    matrix.row(row) /= size;
    right[row] /= size;
  }
  return detail::dense_inverse(matrix) * right;
}

}  // namespace viscoroll::oracle
