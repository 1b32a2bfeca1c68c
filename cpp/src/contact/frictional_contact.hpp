/// @file
/// @brief Steady rolling contact with Coulomb friction: who touches, who sticks, and how fast the sphere moves.
/// Theory.md section 6.
#pragma once

#include <Eigen/Core>

#include "contact/coating_compliance.hpp"
#include "contact/contact_solution.hpp"
#include "contact/normal_contact.hpp"
#include "parallel.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {

/// @brief The lever arm of the pressure in the moment that `DriveTorque` prescribes, sum of (x + u_x) p + (y + u_y) t_x:
/// with the radial compliance, whose pressure does no work along the plane, x alone.
enum class LeverArm { displaced, undisplaced };

/// @brief Besides the conditions of `NormalContactProblem`, a node in contact slides from its upstream neighbor by
/// S_x = speed_ratio step + [x + u_x] and S_z = lateral_creepage step + [u_z], where [.] is the node's value minus its
/// neighbor's (paper equation (55a) without its last approximation). It sticks, S = 0 and |t| <= mu p, or slips,
/// t = -mu p S / |S|.
struct FrictionalContactProblem {
  NormalContactProblem normal;
  WindowShape shape;
  Eigen::ArrayXd x, y;  ///< positions of the undeformed nodes [m]
  Eigen::ArrayXd ways;  ///< [x] of every node [m], < 0
  double step;          ///< r_o times the spacing [m]
  double friction;      ///< mu [-], > 0
  Drive drive;          ///< closes the system for the speed
  LeverArm lever_arm;
};

/// @return moment of the contact forces about the center, with the lever arms of `problem` [N m]
[[nodiscard]] double contact_moment(const FrictionalContactProblem& problem, const ContactSolution& contact);

/// @brief Semismooth Newton method on forces, penetration and speed together, from full stick to the friction wanted,
/// by intermediate values of the friction where a direct jump fails. The steps of small contacts are solved by
/// elimination, those of large ones by products.
/// @param[in] problem coating, shape, load, friction and drive
/// @param[in] start frictionless solution, or one with friction and its speed ratio
/// @param[in] options limits; `max_iterations` is for all linear systems
/// @return a converged state, whose residual is the norm of all violated conditions, in forces, per load
/// @throws ConvergenceError where none was found
/// @throws std::length_error where more than `max_unknowns` come up
[[nodiscard]] ContactSolution solve_frictional_contact(const FrictionalContactProblem& problem,
                                                       const ContactSolution& start, const ContactOptions& options);

}  // namespace viscoroll::detail
