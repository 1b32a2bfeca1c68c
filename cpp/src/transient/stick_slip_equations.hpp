/// @file
/// @brief Linear equations of stick and slip for the nodes in contact and nodes beside them.
///
/// In the sticking state, all covered nodes touch the plane and stick to it; the stiffness of the contact gives the
/// forces of this state. The unknowns are the free displacements, relative to the sticking state: the tangential
/// displacements of slipping nodes, and all displacements of separated nodes.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "base/dense_solvers.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief Condition for a free displacement of a node: force_coefficients . (forces on the node) +
/// displacement_coefficients . (free displacements of the node) = 0.
struct Condition {
  Eigen::Index place;  ///< position of the node among the covered nodes
  Axis axis;           ///< free direction
  Eigen::Vector3d force_coefficients;
  Eigen::Vector3d displacement_coefficients;
};

/// @brief Solution of the equations at the covered nodes [3 * nodes + axis].
struct StickSlipForces {
  Eigen::VectorXd forces;
  Eigen::VectorXd free_displacements;  ///< relative to the sticking state
  double penetration;
  double center_displacement;
};

/// @brief Equations at an instant, for any sets of sticking, slipping and separated nodes.
class StickSlipEquations {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] tangential_compliance displacement of a node along the plane under a unit force on it; scales
  /// conditions relative to forces
  /// @param[in,out] stiffness stiffness of an earlier contact; `cover` adds nodes to it
  StickSlipEquations(const StickSlipProblem& problem, double tangential_compliance, ContactStiffness& stiffness);

  /// @brief Include the nodes of a contact, and nodes that were recently in contact.
  void cover(const std::vector<Eigen::Index>& contact);

  [[nodiscard]] const std::vector<Eigen::Index>& covered() const { return stiffness_.nodes(); }
  /// @brief Add given values to the known gaps and slips of some nodes: the differences between the displacements of
  /// the surface and those that follow from the stiffness.
  void correct(const std::vector<Eigen::Index>& nodes, const Eigen::ArrayXd& gap, const Eigen::ArrayX2d& slip);

  /// @brief Set the condition on the center.
  void set_center_condition(CenterRow row);

  /// @param[in] conditions one for each free displacement; a node without conditions touches the plane and sticks
  /// @return solution; not finite if the equations are singular
  [[nodiscard]] StickSlipForces solve(const std::vector<Condition>& conditions);

 private:
  void set_center_row();
  void set_sticking_state();
  [[nodiscard]] Eigen::MatrixXd forces_by(Eigen::MatrixXd displacements) const;
  [[nodiscard]] Eigen::VectorXd solve_system(const std::vector<Condition>& conditions, const Eigen::MatrixXd& matrix,
                                             const Eigen::VectorXd& right);

  const StickSlipProblem& problem_;
  ContactStiffness& stiffness_;
  double tangential_compliance_;
  CenterRow center_;
  Eigen::ArrayXd gap_;                     // gap of the problem, corrected
  Eigen::ArrayX2d known_slip_;             // slip of the problem, corrected
  std::vector<Eigen::Matrix3d> to_frame_;  // rotations from x, down and z to the frame of the surface at covered nodes
  Eigen::MatrixX3d sticking_displacements_;  // close all gaps and undo all slips; columns: known values, unit
                                             // penetration, unit displacement of the center
  Eigen::MatrixX3d sticking_forces_;         // forces for the sticking displacements
  Eigen::VectorXd center_row_;               // coefficients of displacements in the row of the center
  std::vector<std::pair<Eigen::Index, Axis>> factored_;  // positions and axes of the free displacements in factors_
  DenseFactors factors_;
};

}  // namespace viscoroll::detail
