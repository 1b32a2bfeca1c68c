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
  coarse_mesh,           ///< fewer than ten nodes across the contact on a given mesh
  power_balance,         ///< open by more than a twentieth on a given mesh that is not coarse
  pressure_peak,         ///< the largest pressure is less certain than asked for, or on a given mesh than a tenth
  large_strain,          ///< beyond what linear theory is good for
  contact_at_side,       ///< of a crowned wheel; with endless sides also where it ends nearer to them than the tread is
                         ///< thick
  edge_pressure,         ///< grows without bounds: of a flat tread with endless sides, or a flat wheel on what deforms
  tight_crown,           ///< rounder than the tread is thick
};

/// @brief A warning and its text for people.
struct Warning {
  WarningKind kind;     ///< which
  std::string message;  ///< with the numbers that gave rise to it
};

/// @brief One mesh of a solve that chooses its own.
struct Refinement {
  Mesh mesh;                          ///< the mesh
  int contact_nodes = 0;              ///< nodes in contact
  double resisting_torque = 0.0;      ///< [N m]
  std::optional<double> penetration;  ///< [m], none where it is undetermined
  double power_balance_error = 0.0;   ///< [-]
  double error_estimate = 0.0;        ///< largest of power balance and changes from the mesh before [-]
};

/// @brief The scalar results, in SI units, each a member of the name that `result_scalars.def` gives it.
struct ResultScalars {
#define VISCOROLL_SCALAR(type, name, unit, label, details) type name{};
#include "viscoroll/result_scalars.def"
#undef VISCOROLL_SCALAR
};

/// @brief Solution on the candidate window. Fields are row-major [phi][theta].
struct Result : ResultScalars {
  Status status = Status::converged;  ///< how the solve ended

  Mesh mesh;                           ///< the mesh of this solution
  int phi_nodes = 0;                   ///< rows of the fields
  int theta_nodes = 0;                 ///< columns of the fields
  std::vector<double> x;               ///< forward coordinate of the undeformed nodes [m]
  std::vector<double> z;               ///< lateral coordinate of the undeformed nodes [m]
  std::vector<double> pressure;        ///< contact pressure, positive [Pa]
  std::vector<double> displacement;    ///< vertical displacement of the surface, positive upwards [m]; where the
                                       ///< penetration is undetermined counted from that of the lowest point
  std::vector<double> gap;             ///< height of the surface above the plane [m]
  std::vector<unsigned char> contact;  ///< 1 where the node is in contact
  std::vector<unsigned char> stick;    ///< 1 where it sticks
  std::vector<unsigned char> slip;     ///< 1 where it is in contact and slips
  std::vector<double> shear_traction;  ///< on the coating, along x and z [Pa], [2][phi][theta]
  std::vector<double> slip_velocity;   ///< of the coating over the plane, along x and z, in contact [m/s], likewise

  std::vector<Refinement> refinements;  ///< the meshes tried, coarse to fine; one entry with a mesh given
  std::vector<Warning> warnings;        ///< what to know before relying on this
};

/// @brief Who touches, sticks and slips on a window, and under what: of a result, to be kept in others.
struct KeptContact {
  int phi_nodes = 0;                   ///< rows of the fields, odd: the middle one is the lowest
  int theta_nodes = 0;                 ///< columns, likewise
  std::vector<unsigned char> contact;  ///< 1 where the node is in contact, [phi][theta]
  std::vector<unsigned char> stick;    ///< 1 where it sticks
  std::vector<double> pressure;        ///< [Pa]
  std::vector<double> shear_traction;  ///< [Pa], [2][phi][theta]
  double penetration = 0.0;            ///< [m], 0 where it is undetermined
  double creepage = 0.0;               ///< [-], 0 where it is undetermined
};

}  // namespace viscoroll
