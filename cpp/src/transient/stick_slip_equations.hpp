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
#include "transient/contact_stiffness.hpp"
#include "transient/plane_frame.hpp"

namespace viscoroll::detail {

/// @brief What decides how far the center comes in a step: force * (sum of the forces along the plane) + way * (way of
/// the center) = value.
struct CenterCondition {
  double force = 1.0;
  double way = 0.0;
  double value = 0.0;
};

/// @brief An elastic problem in scaled forces, whose stick and slip belong to the way of this step. Arrays have the
/// nodes row by row.
struct StickSlipProblem {
  const MirroredTables& tables;
  const Axes& axes;
  Eigen::ArrayXd gap;           ///< without these forces, up to a constant
  Eigen::ArrayXd forward_way;   ///< of the nodes over the plane, without these forces and the way of the center
  Eigen::ArrayXd sideways_way;  ///< likewise
  Eigen::ArrayXd weights;       ///< of `half_weights`
  double load;                  ///< sum of the pressing forces
  double friction;              ///< coefficient
  CenterCondition center;       ///< in scaled forces
};

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
  /// @param[in,out] stiffness of an earlier contact
  StickSlipEquations(const StickSlipProblem& problem, ContactStiffness& stiffness);

  /// @brief Have some nodes in the equations, and such as touched lately.
  void cover(const std::vector<Eigen::Index>& contact);

  [[nodiscard]] const std::vector<Eigen::Index>& covered() const { return stiffness_.nodes(); }
  /// @return displacement of a node along the plane by a unit force there
  [[nodiscard]] double own_compliance() const { return own_compliance_; }

  /// @param[in] conditions one for each displacement that is free; what is not, touches and sticks
  /// @return not finite where the equations are singular
  [[nodiscard]] StickSlipForces solve(const std::vector<Condition>& conditions);

 private:
  [[nodiscard]] Eigen::MatrixXd forces_by(Eigen::MatrixXd displacements) const;
  [[nodiscard]] Eigen::VectorXd solved(const std::vector<Condition>& conditions, const Eigen::MatrixXd& matrix,
                                       const Eigen::VectorXd& right);

  const StickSlipProblem& problem_;
  ContactStiffness& stiffness_;
  double own_compliance_;
  std::vector<Eigen::Matrix3d> to_components_;  // r, phi and theta of displacements along the axes, of nodes covered
  Eigen::MatrixX3d closed_;     // displacements that close all gaps and undo all ways: given, by penetration, by way
  Eigen::MatrixX3d by_closed_;  // forces of these
  std::vector<std::pair<Eigen::Index, Axis>> factored_;  // places and axes of the displacements that were free
  DenseFactors factors_;
};

}  // namespace viscoroll::detail
