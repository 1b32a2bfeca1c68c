/// @file
/// @brief Steady rolling contact of a coated sphere on a rigid plane.
///
/// Frame: y points down, x forward (the sense of rolling), phi from x towards y, theta from z; the lowest point is
/// phi = theta = pi/2. Material crosses the contact towards growing phi, so the leading edge has x > 0. Contact
/// tractions on the coating point up (F_W < 0); the pressure -F_W per area is positive outwards to the user.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "viscoroll/cylinder.hpp"
#include "viscoroll/influence.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief What rolls: a sphere, or a roller in line contact, whose loads, forces, torques and powers are per length.
using RollingBody = std::variant<CoatedSphere, CoatedCylinder>;

/// @brief A given horizontal force Q on the center, forward: 0 for a sphere that a torque alone drives.
struct DriveForce {
  double force = 0.0;  ///< Q [N], |Q| < friction * load
};

/// @brief A given driving torque T: 0 for a sphere that is towed.
struct DriveTorque {
  double torque = 0.0;  ///< T [N m]
};

/// @brief A given speed.
struct DriveCreepage {
  double creepage = 0.0;          ///< V_s / (Omega r_o) - 1 [-], forward
  double lateral_creepage = 0.0;  ///< sideways speed of the center, per Omega r_o [-]
};

/// @brief What closes the system for the linear speed V_s.
using Drive = std::variant<DriveForce, DriveTorque, DriveCreepage>;

/// @brief What presses the sphere and turns it.
struct LoadCase {
  double load = 0.0;           ///< P, force on the plane [N], > 0
  double angular_speed = 0.0;  ///< Omega [rad/s], > 0
  double friction = 0.0;       ///< Coulomb's coefficient mu between coating and plane [-], >= 0
  Drive drive;                 ///< without friction, a force of 0 or a creepage
};

/// @brief The compliance in the contact condition (46). Their difference is of the order of the strain: a measure of
/// what linear theory does not know.
enum class Compliance {
  radial,    ///< C_RR (the paper's section 12): pressure along the radius; the one nearer to finite strain, theory.md 5
  vertical,  ///< C_WW, the vertical block of Q^T C_s Q: pressure on the normals of the undeformed sphere
};

/// @brief Traction on the patch of a node under unit nodal force.
enum class PatchLoad {
  flat,       ///< uniform in (phi, theta), equation (53)
  spherical,  ///< proportional to 1/sin(theta), equation (38)
};

/// @brief How far material travels between neighboring nodes of an undeformed sphere that rolls over the plane.
enum class SlipKinematics {
  exact,  ///< the difference of x = r_o sin(theta) cos(phi): away from the middle plane the radius is smaller
  flat,   ///< r_o times the spacing everywhere, the last form of (55a), for comparison with the paper
};

/// @brief How to solve.
struct Options {
  std::optional<Mesh> mesh;                                ///< none: chosen and refined until `accuracy` is reached
  double accuracy = 0.01;                                  ///< wanted relative error without a mesh [-], in [1e-4, 0.5]
  Compliance compliance = Compliance::radial;              ///< compliance in the contact condition
  Curvature curvature = Curvature::sphere;                 ///< what is kept of it in the equations of the layers
  PatchLoad patch_load = PatchLoad::flat;                  ///< traction on a node's patch
  SlipKinematics slip_kinematics = SlipKinematics::exact;  ///< with friction
  int max_iterations = 500;                                ///< linear systems on a mesh, >= 1
  int threads = 0;                                         ///< 0 for all cores
  Observer observer;                                       ///< progress and cancellation
};

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

/// @brief Solve steady rolling of a coated sphere on a rigid plane: paper sections 11 to 13 with the solvers of
/// theory.md sections 5 and 6.
/// @param[in] body rigid core and layers
/// @param[in] load_case load, rolling speed, friction and drive
/// @param[in] options how to solve
/// @return the solution, with its status
/// @throws std::invalid_argument for bad input, a load too large for the coating (penetration >= thickness),
/// speeds at or above `critical_speed`, and drives with which the sphere slides without end
/// @throws ConvergenceError where no usable state was found
/// @throws Cancelled where the observer stopped the solve
[[nodiscard]] Result solve(const RollingBody& body, const LoadCase& load_case, const Options& options = {});

/// @brief A sphere or roller at one speed on one mesh, for many load cases: its spectrum and its influence tables are
/// computed once. Threads may solve on it at the same time.
class RollingModel {
 public:
  /// @param[in] body rigid core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacing and truncation
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] curvature what is kept of it in the equations of the layers
  /// @param[in] observer progress and cancellation
  /// @throws std::invalid_argument for bad input, and speeds at or above `critical_speed`
  RollingModel(const RollingBody& body, double angular_speed, const Mesh& mesh, int threads = 0,
               Curvature curvature = Curvature::sphere, const Observer& observer = {});
  ~RollingModel();
  RollingModel(RollingModel&&) noexcept;
  RollingModel& operator=(RollingModel&&) noexcept;
  RollingModel(const RollingModel&) = delete;
  RollingModel& operator=(const RollingModel&) = delete;

  /// @brief The same as `viscoroll::solve` on this mesh.
  /// @param[in] load_case at the speed of the model
  /// @param[in] options how to solve; the mesh may be left out; accuracy and curvature are not looked at
  [[nodiscard]] Result solve(const LoadCase& load_case, const Options& options = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace viscoroll
