/// @file
/// @brief Results of the solver.
///
/// Frame: x points forward (the sense of rolling), y down and z sideways. phi runs from x towards y, theta is measured
/// from z; the lowest point is phi = theta = pi/2. Material crosses the contact towards growing phi, so the leading
/// edge has x > 0. The contact forces act upwards on the rolling body (F_W < 0); the pressure, -F_W per area, is
/// positive.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscoroll/mesh.hpp"

namespace viscoroll {

/// @brief State in which a solve ended.
enum class Status {
  converged,             ///< all conditions are satisfied and, without a given mesh, the required accuracy is reached
  max_iterations,        ///< the active set still changed after the largest number of iterations
  accuracy_not_reached,  ///< solved on the finest mesh allowed, with an error estimate above the required accuracy
};

/// @brief Kinds of warnings about a result.
enum class WarningKind {
  max_iterations,        ///< the active set still changed after the largest number of iterations
  accuracy_not_reached,  ///< the error estimate exceeds the required accuracy
  coarse_mesh,      ///< fewer than ten nodes across the contact, on a given mesh; with adhesion, long cohesive zones
  power_balance,    ///< the power balance has an error above 5 %, on a given mesh that is not coarse, or with adhesion
  pressure_peak,    ///< the relative error of the largest pressure exceeds `accuracy`, or 10 % on a given mesh
  large_strain,     ///< the strain is beyond the range of linear theory
  contact_at_side,  ///< the contact reaches the faces of a crowned wheel, or with unbounded sides ends closer to them
                    ///< than the thickness of the tread
  edge_pressure,    ///< the pressure is singular at the edges of a flat tread with unbounded sides, or of a flat
                    ///< wheel on a deformable counterbody
  tight_crown,      ///< the crown radius is smaller than the thickness of the tread
  slow_terms,       ///< terms of a Prony series are too slow to relax at this speed
};

/// @brief A warning about a result.
struct Warning {
  WarningKind kind;     ///< kind of the warning
  std::string message;  ///< text with the numbers that caused the warning
};

/// @brief Results on one mesh of a solve that refines its mesh.
struct Refinement {
  Mesh mesh;                          ///< the mesh
  int contact_nodes = 0;              ///< nodes in contact
  double resisting_torque = 0.0;      ///< [N m]
  std::optional<double> penetration;  ///< [m]; none if it is undetermined
  double energy_balance_error = 0.0;  ///< [-]
  double error_estimate = 0.0;  ///< largest of the energy-balance error and the changes from the previous mesh [-]
};

/// @brief Scalar results in SI units. The members have the names in `result_scalars.def`.
struct ResultScalars {
#define VISCOROLL_SCALAR(type, name, group, precision, unit, label, details) type name{};
#include "viscoroll/result_scalars.def"
#undef VISCOROLL_SCALAR
};

/// @brief Solution on the window of candidate nodes. Fields are row-major [phi][theta].
struct Result : ResultScalars {
  Status status = Status::converged;  ///< state in which the solve ended

  Mesh mesh;                         ///< mesh of this solution
  int phi_nodes = 0;                 ///< rows of the fields
  int theta_nodes = 0;               ///< columns of the fields
  std::vector<double> x;             ///< forward coordinate of the undeformed nodes [m]
  std::vector<double> z;             ///< lateral coordinate of the undeformed nodes [m]
  std::vector<double> pressure;      ///< contact pressure, positive [Pa]
  std::vector<double> displacement;  ///< vertical displacement of the surface, positive upwards [m]; if the penetration
                                     ///< is undetermined, relative to the displacement of the lowest point
  std::vector<double> gap;           ///< distance of the surface from the counterbody [m]
  std::vector<unsigned char> contact;  ///< 1 if the node is in contact, else 0
  std::vector<unsigned char> stick;    ///< 1 if the node sticks, else 0
  std::vector<unsigned char> slip;     ///< 1 if the node is in contact and slips, else 0
  std::vector<double> shear_traction;  ///< traction on the rolling body along x and z [Pa], [2][phi][theta]
  std::vector<double> slip_velocity;   ///< velocity of the rolling body's surface relative to the counterbody along x
                                       ///< and z, at nodes in contact [m/s], [2][phi][theta]

  std::vector<Refinement> refinements;  ///< one entry for each mesh, coarse to fine; a single one on a given mesh
  std::vector<Warning> warnings;        ///< warnings about this result
};

/// @brief Frozen contact of a result, for `solve_frozen`: nodes in contact and sticking, and their tractions.
struct FrozenContact {
  int phi_nodes = 0;                   ///< rows of the fields, odd; the middle one is at the lowest point
  int theta_nodes = 0;                 ///< columns of the fields, odd; the middle one is at the lowest point
  std::vector<unsigned char> contact;  ///< 1 if the node is in contact, else 0, [phi][theta]
  std::vector<unsigned char> stick;    ///< 1 if the node sticks, else 0, [phi][theta]
  std::vector<double> pressure;        ///< [Pa], [phi][theta]
  std::vector<double> shear_traction;  ///< along x and z [Pa], [2][phi][theta]
  double penetration = 0.0;            ///< [m]; 0 if it is undetermined
  double creepage = 0.0;               ///< [-]; 0 if it is undetermined
};

/// @return contact and tractions of a result
[[nodiscard]] FrozenContact frozen_contact(const Result& result);

}  // namespace viscoroll
