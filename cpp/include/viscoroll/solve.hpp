/// @file
/// @brief Steady rolling contact of a coated sphere on a rigid plane.
///
/// Frame: y points down, x forward (the sense of rolling), phi from x towards y, theta from z; the lowest point is
/// phi = theta = pi/2. Material crosses the contact towards growing phi, so the leading edge has x > 0. Contact
/// tractions on the coating point up (F_W < 0); the pressure -F_W per area is positive outwards to the user.
#pragma once

#include <optional>
#include <vector>

#include "viscoroll/influence.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief What presses the sphere and turns it.
struct LoadCase {
  double load = 0.0;           ///< P, force on the plane [N], > 0
  double angular_speed = 0.0;  ///< Omega [rad/s], > 0
};

/// @brief The compliance in the contact condition (46).
enum class Compliance {
  vertical,  ///< C_WW, the vertical block of Q^T C_s Q: the model itself
  radial,    ///< C_RR in its place, the paper's shortcut (section 12), with which its tables were made
};

/// @brief Traction on the patch of a node under unit nodal force.
enum class PatchLoad {
  flat,       ///< uniform in (phi, theta), equation (53)
  spherical,  ///< proportional to 1/sin(theta), equation (38)
};

/// @brief How to solve.
struct Options {
  std::optional<Mesh> mesh;                      ///< none: chosen and refined until `accuracy` is reached
  double accuracy = 0.01;                        ///< wanted relative error without a mesh [-], in [1e-4, 0.5]
  Compliance compliance = Compliance::vertical;  ///< compliance in the contact condition
  PatchLoad patch_load = PatchLoad::flat;        ///< traction on a node's patch
  int max_iterations = 100;                      ///< passes of the active set, >= 1
  int threads = 0;                               ///< 0 for all cores
  Observer observer;                             ///< progress and cancellation
};

/// @brief How a solve ended.
enum class Status {
  converged,             ///< every condition holds, and the wanted accuracy where one was asked for
  max_iterations,        ///< the active set still changed when the passes ran out
  accuracy_not_reached,  ///< solved on the finest mesh allowed, with an error estimate above the wanted accuracy
};

/// @brief One mesh of a solve that chooses its own.
struct Refinement {
  Mesh mesh;                         ///< the mesh
  int contact_nodes = 0;             ///< nodes in contact
  double resisting_torque = 0.0;     ///< [N m]
  double penetration = 0.0;          ///< [m]
  double power_balance_error = 0.0;  ///< [-]
  double error_estimate = 0.0;       ///< largest of power balance and change from the mesh before [-]
};

/// @brief Solution on the candidate window. Fields are row-major [phi][theta].
struct Result {
  Status status = Status::converged;  ///< how the solve ended
  int iterations = 0;                 ///< passes of the active set
  double residual = 0.0;              ///< largest violation of the contact conditions relative to the penetration [-]

  double resisting_torque = 0.0;                ///< T_r = sum of x p, offset of the normal resultant times load [N m]
  double rolling_resistance_coefficient = 0.0;  ///< T_r / (P r_o) [-]
  double center_height = 0.0;                   ///< H, centre of the sphere above the plane [m]
  double penetration = 0.0;                     ///< r_o - H [m]
  double semi_axis_x = 0.0;                     ///< of the ellipse with the contact's second moments [m]
  double semi_axis_z = 0.0;                     ///< of the ellipse with the contact's second moments [m]
  double contact_area = 0.0;                    ///< [m^2]
  double max_pressure = 0.0;                    ///< [Pa]

  /// Moment of the contact tractions at displaced positions, sum of (x + u_x) p [N m]: the torque that does the work
  /// of the linear model. Equals `resisting_torque` with the radial compliance, which has no u_x.
  double work_torque = 0.0;
  double dissipated_power = 0.0;          ///< power lost in the coating, from the spectrum [W]
  double power_balance_error = 0.0;       ///< |work_torque Omega - dissipated_power| relative to the larger [-]
  double centrifugal_displacement = 0.0;  ///< d_R^(c) in the contact condition [m]

  Mesh mesh;                           ///< the mesh of this solution
  double spacing = 0.0;                ///< angle between neighbouring nodes [rad]
  int phi_nodes = 0;                   ///< rows of the fields
  int theta_nodes = 0;                 ///< columns of the fields
  std::vector<double> x;               ///< forward coordinate of the undeformed nodes [m]
  std::vector<double> z;               ///< lateral coordinate of the undeformed nodes [m]
  std::vector<double> pressure;        ///< contact pressure, positive [Pa]
  std::vector<double> displacement;    ///< vertical displacement of the surface, positive upwards [m]
  std::vector<double> gap;             ///< height of the surface above the plane [m]
  std::vector<unsigned char> contact;  ///< 1 where the node is in contact

  double error_estimate = 0.0;          ///< relative error estimate [-]: the power balance with a mesh given
  std::vector<Refinement> refinements;  ///< the meshes tried, coarse to fine; one entry with a mesh given
};

/// @brief Solve steady frictionless rolling of a coated sphere on a rigid plane: paper sections 11 and 12 with the
/// active set of theory.md section 5.
/// @param[in] sphere rigid core and layers
/// @param[in] load_case load and rolling speed
/// @param[in] options how to solve
/// @return the solution, with its status
/// @throws std::invalid_argument for bad input, a load too large for the coating (penetration >= thickness), and
/// speeds at or above `critical_speed`
/// @throws ConvergenceError where no usable state was found
/// @throws Cancelled where the observer stopped the solve
[[nodiscard]] Result solve(const CoatedSphere& sphere, const LoadCase& load_case, const Options& options = {});

}  // namespace viscoroll
