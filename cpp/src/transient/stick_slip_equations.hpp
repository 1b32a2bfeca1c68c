/// @file
/// @brief Linear equations of stick and slip for the nodes in contact and nodes beside them.
///
/// The stiffness of a contact gives its forces if all nodes touched the plane and stuck to it. The unknowns are the
/// differences of the free displacements from that state: tangential displacements of slipping nodes, and all
/// displacements of separated nodes.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "dense_solvers.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief Condition for a free displacement: on_force . (forces on the node) + on_move . (its free displacements) = 0.
struct Condition {
  Eigen::Index place;  ///< position of the node among the covered nodes
  Axis axis;           ///< free direction
  Eigen::Vector3d on_force;
  Eigen::Vector3d on_move;
};

/// @brief Solution of the equations at the covered nodes [3 * nodes + axis].
struct StickSlipForces {
  Eigen::VectorXd forces;
  Eigen::VectorXd moves;  ///< free displacements
  double penetration;
  double center_displacement;
};

/// @brief Equations at an instant, for any sets of sticking, slipping and separated nodes.
class StickSlipEquations {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] own_compliance of a node along the plane; scales conditions relative to forces
  /// @param[in,out] stiffness of an earlier contact
  StickSlipEquations(const StickSlipProblem& problem, double own_compliance, ContactStiffness& stiffness);

  /// @brief Include the nodes of a contact, and nodes that were recently in contact.
  void cover(const std::vector<Eigen::Index>& contact);

  [[nodiscard]] const std::vector<Eigen::Index>& covered() const { return stiffness_.nodes(); }
  /// @brief Add known differences of gaps and slips of nodes to the equations, where the surface differs from that of
  /// the stiffness.
  void correct(const std::vector<Eigen::Index>& nodes, const Eigen::ArrayXd& gap, const Eigen::ArrayX2d& slip);

  /// @brief Set the condition on the center.
  void drive(CenterRow row);

  /// @param[in] conditions one for each free displacement; without a condition, a node touches and sticks
  /// @return solution; not finite if the equations are singular
  [[nodiscard]] StickSlipForces solve(const std::vector<Condition>& conditions);

 private:
  void weigh_center();
  void close();
  [[nodiscard]] Eigen::MatrixXd forces_by(Eigen::MatrixXd displacements) const;
  [[nodiscard]] Eigen::VectorXd solved(const std::vector<Condition>& conditions, const Eigen::MatrixXd& matrix,
                                       const Eigen::VectorXd& right);

  const StickSlipProblem& problem_;
  ContactStiffness& stiffness_;
  double own_compliance_;
  CenterRow center_;
  Eigen::ArrayXd gap_;                     // gap of the problem, corrected
  Eigen::ArrayX2d known_slip_;             // slip of the problem, corrected
  std::vector<Eigen::Matrix3d> to_frame_;  // from the axes to the frame of the surface, for each covered node
  Eigen::MatrixX3d closed_;     // close all gaps and undo all slips: columns for given values, penetration, center
  Eigen::MatrixX3d by_closed_;  // forces of these displacements
  Eigen::VectorXd by_center_;   // coefficients of displacements in the row of the center
  std::vector<std::pair<Eigen::Index, Axis>> factored_;  // positions and axes of the displacements that were free
  DenseFactors factors_;
};

}  // namespace viscoroll::detail
