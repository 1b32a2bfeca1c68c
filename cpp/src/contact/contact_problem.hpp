/// @file
/// @brief Contact problem: an operator for the displacement due to nodal forces, and arrays for everything else.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "contact/contact_solution.hpp"
#include "contact/drive.hpp"
#include "contact/shared_start.hpp"
#include "contact/traction_law.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Coulomb friction in rolling.
/// The slip of a node in contact relative to its upstream neighbor is S = rigid_slip + [u] + creepage
/// (counterbody_rigid_displacement + [u_2]), along x and z. [.] is the value at the node minus the value at its
/// upstream neighbor, and u_2 the part of the counterbody in u, whose material passes 1 + creepage times as fast as
/// that of the rolling body. The node sticks, S = 0 and |t| <= mu p, or slips, t = -mu p S / |S|.
struct Friction {
  double coefficient;  ///< coefficient of friction mu [-], positive
  /// Slip of the undeformed bodies at zero creepage, per row, along x and z [m]; 0 in row 0.
  Eigen::ArrayX2d rigid_slip;
  /// Displacement of the undeformed counterbody's surface at zero creepage, per row, along x and z [m]; 0 in row 0.
  Eigen::ArrayX2d counterbody_rigid_displacement;
  double step;  ///< distance between rows [m]
  MomentArms arms;
  std::shared_ptr<const DriveCondition> drive;
  /// States shared with problems that differ only in the coefficient, on this window; null if there are none.
  std::shared_ptr<SharedStart> shared = {};
};

/// @brief Condition on the sum of the pressing forces or on the penetration, one row of the system with the dimension
/// of a force: per_force * sum p + per_penetration * stiffness * penetration = value.
struct NormalCondition {
  double per_force;        ///< 1 if the load is given, else 0
  double per_penetration;  ///< 1 if the penetration is given, else 0
  double value;            ///< [N]
};

/// @brief Find forces p >= 0 and the penetration for which the bodies are in contact where p > 0 and separated
/// elsewhere: gap = initial_gap - u_y - penetration >= 0, p gap = 0, and either sum p = normal_force or the penetration
/// is given. With adhesion, the force of a node is the pressure of a hard wall minus an attraction that depends on the
/// gap, times the area.
struct ContactProblem {
  std::shared_ptr<const SurfaceOperator> surface;
  Eigen::ArrayXd initial_gap;  ///< gap of each node when the lowest node just touches [m], >= 0
  double normal_force;         ///< load [N], positive without adhesion; with a given penetration, a scale for residuals
  std::optional<Friction> friction;  ///< empty if tangential forces are neglected
  /// Whether a body ends at the sides of the window, so that the contact may reach them.
  bool ends_at_sides = false;
  /// Given penetration of the lowest undeformed node, including its centrifugal growth [m]; empty if the load is given.
  std::optional<double> penetration = {};
  std::optional<Attraction> attraction = {};  ///< empty without adhesion
  /// Whether the load is the largest tension that adhesion supports, instead of a given load or penetration.
  bool largest_tension = false;

  /// @param[in] stiffness stiffness that converts the penetration to a force [N/m]
  [[nodiscard]] NormalCondition normal_condition(double stiffness) const;
};

/// @brief Limits of a contact solver.
struct ContactOptions {
  int max_iterations;        ///< largest number of linear systems
  double tolerance = 1e-11;  ///< relative residual of the last systems; with friction, residual per load
  double unsettled = 0.0;    ///< fraction of nodes that may still leave or join, without friction
  /// Whether another solution starts from this one, so that sticking nodes may still slip slightly.
  bool is_start = false;
};

/// @return the problem on a mesh of every other node
[[nodiscard]] ContactProblem coarsened(const ContactProblem& problem);

/// @return the problem on a window inside its own
[[nodiscard]] ContactProblem within(const ContactProblem& problem, const Window& window);

/// @brief Set the scale for residuals to the load of a state, unless the load is given.
void scale_by(const ContactSolution& state, ContactProblem& problem);

/// @return whether the problem is symmetric about the middle of the path
[[nodiscard]] bool is_mirror_symmetric(const ContactProblem& problem);

/// @param[in] displacement displacement of every node [m]
/// @param[in] stride nodes per row
/// @return displacement of each node minus that of its upstream neighbor, along x and z [m], 0 in the first row
[[nodiscard]] Eigen::ArrayX2d increments(const VectorField& displacement, Eigen::Index stride);

/// @brief Slip of the nodes relative to their upstream neighbors.
/// @param[in] friction kinematics
/// @param[in] stride nodes per row
/// @param[in] state state with its displacements
/// @return slip along x and z [m], 0 in the first row
[[nodiscard]] Eigen::ArrayX2d slip(const Friction& friction, Eigen::Index stride, const ContactSolution& state);

}  // namespace viscoroll::detail
