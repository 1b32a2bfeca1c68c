/// @file
/// @brief Works of adhesion with which a mesh that does not resolve the edges of an adhesive contact lets the same
/// stress intensity through: docs/theory/adhesion.md, "Edges finer than the mesh".
///
/// The cohesive zone of rubber on a smooth surface is nanometers long. Such an edge acts on the rest of the contact
/// through its stress intensity alone. A traction law with a smaller strength has a longer zone, and the same stress
/// intensity if its work is changed. The work then differs between the opening edge, where the surfaces separate, and
/// the closing edge.
#pragma once

#include <limits>
#include <vector>

#include "contact/traction_law.hpp"
#include "materials/creep_spectrum.hpp"
#include "rolling/rolling_pair.hpp"

namespace viscoroll::detail {

/// @brief Creep compliance of a contact on the scale of its edges, J(t) = J_0 + sum_j J_j (1 - exp(-t / lambda_j)): the
/// sum of 1/E*, with E* = 2 G / (1 - nu), of the outermost layers of both bodies.
struct EdgeCreep {
  double instantaneous = 0.0;                  ///< J_0 [1/Pa]
  std::vector<double> delayed = {};            ///< J_j [1/Pa]
  std::vector<double> retardation_times = {};  ///< lambda_j [s]

  /// @return J_0 + sum_j J_j [1/Pa]
  [[nodiscard]] double relaxed() const;
};

/// @brief Creep compliance of the outermost layers of both bodies. A rigid body contributes nothing.
///
/// For a bulk modulus K, 1/E* = 1/(4 G) + 1/(4 (K + G/3)). The second part is taken to creep at the retardation times
/// of 1/G; its values at short and long times are exact.
/// @param[in] pair both bodies, at least one of which is deformable
/// @param[in] range times in which continuous spectra are resolved, see `creep_spectrum`
[[nodiscard]] EdgeCreep edge_creep(const RollingPair& pair, const TimeRange& range);

/// @brief Adhesion of two surfaces.
struct SurfaceAdhesion {
  double separation_work;                                     ///< work of adhesion at the opening edge [J/m^2], > 0
  double bonding_work;                                        ///< work of adhesion at the closing edge [J/m^2], > 0
  double strength = std::numeric_limits<double>::infinity();  ///< peak of the cubic traction law [Pa], > 0
};

/// @brief Edges of a contact, and the laws of a mesh that represent them.
struct EdgeWorks {
  EdgeLaws laws;               ///< laws of the mesh
  double opening_release;      ///< energy release rate by the relaxed compliance, G_open [J/m^2]
  double closing_release;      ///< energy release rate by the relaxed compliance, G_close [J/m^2]
  double actual_opening_zone;  ///< length of the cohesive zone of the surfaces; 0 with an infinite strength [m]
  double actual_closing_zone;  ///< length of the cohesive zone of the surfaces; 0 with an infinite strength [m]
};

/// @brief Laws with cohesive zones of a given length that have the stress intensities of the given adhesion.
///
/// Opening edge: the traction is elastic, with the stress intensity K; the gap creeps. Closing edge: the displacement
/// is the elastic one of the strain that the attraction ahead of the contact causes. Both zones have the shape of D. S.
/// Dugdale, J. Mech. Phys. Solids 8 (1960) 100-104. An edge whose own zone is longer than the given one has the given
/// adhesion. Both works are the given ones if the bodies are elastic, and at low speed.
/// @param[in] creep creep compliance at the edges
/// @param[in] adhesion works and strength of the surfaces
/// @param[in] zone length of the cohesive zones on the mesh [m], > 0
/// @param[in] speed component of the rolling speed normal to the edge [m/s], >= 0
/// @throws InvalidInput for an infinite strength if the works depend on it: without an instantaneous compliance, and
/// with retardation times that span more than two decades
[[nodiscard]] EdgeWorks edge_works(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double zone, double speed);

/// Longest cohesive zone on a mesh, relative to the half-width of the contact, at which an edge still acts on the
/// contact through its stress intensity alone. With zones of 0.4, 0.2 and 0.1 half-widths, the moment of a roller on a
/// half-plane has errors of up to 11, 4 and 1.2 % (`python -m tests.reference.adhesion`).
inline constexpr double kLongestZone = 0.4;

}  // namespace viscoroll::detail
