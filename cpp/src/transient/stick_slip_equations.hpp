/// @file
/// @brief The linear equations of stick and slip for nodes in contact, and nodes beside them.
///
/// The stiffness of a contact gives its forces if all nodes touched the plane and stuck to it. Unknown is how far the
/// displacements that are free are from that: of slipping nodes along the plane, of nodes apart in all directions.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "dense_solvers.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief What holds where a displacement is free: on_force . (forces on the node) + on_move . (its free displacements)
/// = 0.
struct Condition {
  Eigen::Index place;  ///< of the node among those covered
  Axis axis;           ///< that is free
  Eigen::Vector3d on_force;
  Eigen::Vector3d on_move;
};

/// @brief What the equations give, of the nodes covered [3 * nodes + axis].
struct StickSlipForces {
  Eigen::VectorXd forces;
  Eigen::VectorXd moves;  ///< of free displacements
  double penetration;
  double way;  ///< of the center
};

/// @brief Equations of one instant, whatever its nodes do.
class StickSlipEquations {
 public:
  /// @param[in] problem which outlives this object
  /// @param[in] own_compliance of a node along the plane, which weighs conditions against forces
  /// @param[in,out] stiffness of an earlier contact
  StickSlipEquations(const StickSlipProblem& problem, double own_compliance, ContactStiffness& stiffness);

  /// @brief Have some nodes in the equations, and such as touched lately.
  void cover(const std::vector<Eigen::Index>& contact);

  [[nodiscard]] const std::vector<Eigen::Index>& covered() const { return stiffness_.nodes(); }
  /// @brief Take for known by how much gaps and slips of nodes are more than the equations have them, where the surface
  /// is not quite that of the stiffness.
  void correct(const std::vector<Eigen::Index>& nodes, const Eigen::ArrayXd& gap, const Eigen::ArrayX2d& slip);

  /// @brief What is to hold for the center.
  void drive(CenterRow row);

  /// @param[in] conditions one for each displacement that is free; what is not, touches and sticks
  /// @return not finite where the equations are singular
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
  Eigen::ArrayXd gap_;                     // of the problem, corrected,
  Eigen::ArrayX2d way_;                    // and likewise
  std::vector<Eigen::Matrix3d> to_frame_;  // of the surface, of displacements along the axes, of nodes covered
  Eigen::MatrixX3d closed_;     // displacements that close all gaps and undo all ways: given, by penetration, by way
  Eigen::MatrixX3d by_closed_;  // forces of these
  Eigen::VectorXd by_center_;   // what the center's row makes of displacements
  std::vector<std::pair<Eigen::Index, Axis>> factored_;  // places and axes of the displacements that were free
  DenseFactors factors_;
};

}  // namespace viscoroll::detail
