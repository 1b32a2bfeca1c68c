/// @file
/// @brief A contact problem: what nodal forces do to the surface, and plain numbers for everything else.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "contact/contact_solution.hpp"
#include "contact/drive.hpp"
#include "contact/shared_start.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Coulomb friction in rolling. A node in contact slides from its upstream neighbor by
/// S = rigid_slip + [u] + creepage (counterpart_way + [u_2]), where [.] is the node's value minus its neighbor's, along
/// x and z, and u_2 the counterpart's share of u, whose material passes 1 + creepage times as fast as that of what
/// rolls. It sticks, S = 0 and |t| <= mu p, or slips, t = -mu p S / |S|.
struct Friction {
  double coefficient;          ///< mu [-], > 0
  Eigen::ArrayX2d rigid_slip;  ///< of undeformed bodies without creepage, from row to row along x and z [m]; 0 in row 0
  /// Ways of the undeformed counterpart's surface at a creepage of 0, from row to row along x and z [m]; 0 in row 0
  Eigen::ArrayX2d counterpart_way;
  double step;  ///< distance of two rows [m]
  LeverArms arms;
  std::shared_ptr<const DriveCondition> drive;
  /// With problems that differ by their coefficient alone, on this window; none where there are no others.
  std::shared_ptr<SharedStart> shared = {};
};

/// @brief Find forces p >= 0 and how deep the bodies approach one another such that they touch where p > 0 and are
/// clear elsewhere: gap = initial_gap - u_y - penetration >= 0, p gap = 0, sum p = normal_force.
struct ContactProblem {
  std::shared_ptr<const SurfaceOperator> surface;
  Eigen::ArrayXd initial_gap;        ///< of each node when the lowest one just touches [m], >= 0
  double normal_force;               ///< the load [N], > 0
  std::optional<Friction> friction;  ///< none where forces along the plane are left out
  /// Whether a body ends at the sides of the window, up to which it may touch.
  bool ends_at_sides = false;
};

/// @brief Limits of a contact solver.
struct ContactOptions {
  int max_iterations;        ///< linear systems
  double tolerance = 1e-11;  ///< relative residual of the last systems, and of friction per normal force
  double unsettled = 0.0;    ///< share of nodes that may be about to leave or join without friction
  bool is_start = false;     ///< whether what is found is where another one starts: creep need not come to rest
};

/// @return the problem with every other node
[[nodiscard]] ContactProblem coarsened(const ContactProblem& problem);

/// @return the problem on a window inside its own
[[nodiscard]] ContactProblem within(const ContactProblem& problem, const Window& window);

/// @return whether mirror images, sideways, are told the same
[[nodiscard]] bool is_mirror_symmetric(const ContactProblem& problem);

/// @param[in] displacement of every node [m]
/// @param[in] stride nodes of a row
/// @return what nodes are displaced more than their upstream neighbors, along x and z [m], 0 in the first row
[[nodiscard]] Eigen::ArrayX2d increments(const VectorField& displacement, Eigen::Index stride);

/// @brief The ways that nodes slide from their upstream neighbors.
/// @param[in] friction kinematics
/// @param[in] stride nodes of a row
/// @param[in] state with its displacements
/// @return along x and z [m], 0 in the first row
[[nodiscard]] Eigen::ArrayX2d slip(const Friction& friction, Eigen::Index stride, const ContactSolution& state);

}  // namespace viscoroll::detail
