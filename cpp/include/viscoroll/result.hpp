/// @file
/// @brief What a solve returns.
///
/// Frame: y points down, x forward (the sense of rolling), phi from x towards y, theta from z; the lowest point is
/// phi = theta = pi/2. Material crosses the contact towards growing phi, so the leading edge has x > 0. Contact
/// tractions on the coating point up (F_W < 0); the pressure -F_W per area is positive outwards to the user.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscoroll/mesh.hpp"

namespace viscoroll {

/// @brief How a solve ended.
enum class Status {
  converged,             ///< every condition holds, and the wanted accuracy where one was asked for
  max_iterations,        ///< the active set still changed when the iterations ran out
  accuracy_not_reached,  ///< solved on the finest mesh allowed, with an error estimate above the wanted accuracy
};

/// @brief What a user should know before relying on a result.
enum class WarningKind {
  max_iterations,        ///< the active set still changed when the iterations ran out
  accuracy_not_reached,  ///< the error estimate stays above the accuracy that was asked for
  coarse_mesh,           ///< fewer than ten nodes across the contact on a given mesh, or a large error estimate there
  large_strain,          ///< beyond what linear theory is good for
};

/// @brief A warning and its text for people.
struct Warning {
  WarningKind kind;
  std::string message;
};

/// @brief One mesh of a solve that chooses its own.
struct Refinement {
  Mesh mesh;                         ///< the mesh
  int contact_nodes = 0;             ///< nodes in contact
  double resisting_torque = 0.0;     ///< [N m]
  double penetration = 0.0;          ///< [m]
  double power_balance_error = 0.0;  ///< [-]
  double error_estimate = 0.0;       ///< largest of power balance and changes from the mesh before [-]
};

/// @brief Solution on the candidate window. Fields are row-major [phi][theta].
struct Result {
  Status status = Status::converged;  ///< how the solve ended
  int iterations = 0;                 ///< linear systems solved on the last mesh
  int products = 0;                   ///< with the influence tables, by which they were solved
  /// Largest violation of the contact conditions: a gap relative to the penetration without friction; with friction the
  /// norm of all of them, as forces relative to the load [-].
  double residual = 0.0;

  double resisting_torque = 0.0;  ///< T_r = sum of x p, offset of the normal resultant times load [N m]
  /// Power lost per load and way, dissipated_power / (P |V|), whatever drives the sphere [-]; V is the speed of the
  /// center where it is determined, else Omega r_o. Infinite where the center stands still.
  double rolling_resistance_coefficient = 0.0;
  double center_height = 0.0;  ///< H, centre of the sphere above the plane [m]
  double penetration = 0.0;    ///< r_o - H [m]
  double strain = 0.0;         ///< penetration per thickness of the coating [-]
  /// What linear theory does not know, relative, of torque and penetration with the radial compliance: 3/4 of the
  /// strain, which covers finite-strain computations up to a strain of 0.24 (theory.md section 5) [-].
  double model_error = 0.0;
  double semi_axis_x = 0.0;   ///< of the ellipse with the contact's second moments [m]
  double semi_axis_z = 0.0;   ///< of the ellipse with the contact's second moments [m]
  double contact_area = 0.0;  ///< [m^2]
  double max_pressure = 0.0;  ///< [Pa]

  /// T, moment of the contact forces about the center [N m]: what turns the sphere, and does the work of the model.
  /// With the radial compliance sum of x p + (y + u_y) t_x = T_r - Q H, with the vertical one, whose pressure does work
  /// along the plane too, sum of (x + u_x) p + (y + u_y) t_x.
  double driving_torque = 0.0;
  double driving_force = 0.0;          ///< Q = -sum of t_x [N]
  double lateral_force = 0.0;          ///< sum of t_z, of the plane on the sphere [N]
  std::optional<double> linear_speed;  ///< V_s [m/s]; undetermined without friction, unless given
  std::optional<double> creepage;      ///< V_s / (Omega r_o) - 1 [-]
  double bulk_power = 0.0;             ///< lost in the coating, from the spectrum [W]
  double slip_power = 0.0;             ///< lost by slip on the plane [W]
  double dissipated_power = 0.0;       ///< bulk_power + slip_power [W]
  /// |T Omega + Q V_s - dissipated_power| relative to the larger [-], with the lateral force's work where there is
  /// some.
  double power_balance_error = 0.0;
  double centrifugal_displacement = 0.0;  ///< d_R^(c) in the contact condition [m]

  Mesh mesh;                           ///< the mesh of this solution
  int phi_nodes = 0;                   ///< rows of the fields
  int theta_nodes = 0;                 ///< columns of the fields
  std::vector<double> x;               ///< forward coordinate of the undeformed nodes [m]
  std::vector<double> z;               ///< lateral coordinate of the undeformed nodes [m]
  std::vector<double> pressure;        ///< contact pressure, positive [Pa]
  std::vector<double> displacement;    ///< vertical displacement of the surface, positive upwards [m]
  std::vector<double> gap;             ///< height of the surface above the plane [m]
  std::vector<unsigned char> contact;  ///< 1 where the node is in contact
  std::vector<unsigned char> stick;    ///< 1 where it sticks
  std::vector<unsigned char> slip;     ///< 1 where it is in contact and slips
  std::vector<double> shear_traction;  ///< on the coating, along x and z [Pa], [2][phi][theta]
  std::vector<double> slip_velocity;   ///< of the coating over the plane, along x and z, in contact [m/s], likewise

  /// Relative error estimate [-]: with a mesh given the power balance, else the largest of it and of the changes, from
  /// the mesh before, of all that was not given: penetration, torques, forces, speed and powers.
  double error_estimate = 0.0;
  std::vector<Refinement> refinements;  ///< the meshes tried, coarse to fine; one entry with a mesh given
  std::vector<Warning> warnings;        ///< what to know before relying on this
};

}  // namespace viscoroll
