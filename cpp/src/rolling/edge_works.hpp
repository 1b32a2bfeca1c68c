/// @file
/// @brief Works of adhesion with which a mesh that does not resolve the edges of an adhesive contact has the same
/// stress intensity: docs/theory/adhesion.md, "Edges finer than the mesh".
///
/// The cohesive zone of rubber on a smooth surface is nanometers long. Such an edge acts on the rest of the contact
/// through its stress intensity alone. A traction law with a smaller strength has a longer zone, and the same stress
/// intensity if its work is changed. The work then differs between the opening edge, where the surfaces separate, and
/// the closing edge.
#pragma once

#include <limits>

#include "contact/traction_law.hpp"
#include "materials/creep_spectrum.hpp"
#include "rolling/cohesive_edge.hpp"
#include "rolling/rolling_pair.hpp"

namespace viscoroll::detail {

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

/// @brief Edges of a contact as they act on the rest of it.
struct EdgeIntensities {
  double opening;       ///< stress intensity K of the opening edge [Pa m^(1/2)]
  double closing;       ///< intensity K_c of the strain at the closing edge [m^(1/2)]
  double opening_zone;  ///< length of the cohesive zone of the surfaces; 0 with an infinite strength [m]
  double closing_zone;  ///< length of the cohesive zone of the surfaces; 0 with an infinite strength [m]
};

/// @brief Stress intensities of both edges. The energy release rates by the relaxed compliance J are K^2 J / 2 and
/// K_c^2 / (2 J). Both are the works if the bodies are elastic, and at low speed.
/// @param[in] creep creep compliance at the edges
/// @param[in] adhesion works and strength of the surfaces
/// @param[in] speed component of the rolling speed normal to the edge [m/s], >= 0
/// @throws InvalidInput for an infinite strength if the works depend on it: without an instantaneous compliance, and
/// with retardation times that span more than two decades
[[nodiscard]] EdgeIntensities edge_intensities(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, double speed);

/// @brief Laws of a mesh with cohesive zones of a given length that have the given stress intensities. An edge whose
/// own zone is longer than the given one has the given adhesion.
/// @param[in] creep creep compliance at the edges
/// @param[in] adhesion works and strength of the surfaces
/// @param[in] edges stress intensities at the same speed
/// @param[in] zone length of the cohesive zones on the mesh [m], > 0
/// @param[in] speed component of the rolling speed normal to the edge [m/s], >= 0
/// @param[in] contact size of the contact; an infinite `half_length` neglects the second term of the pressure
[[nodiscard]] EdgeLaws edge_laws(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, const EdgeIntensities& edges,
                                 double zone, double speed, const ContactSize& contact = {});

/// Longest cohesive zone on a mesh, relative to the half-width of the contact and to the thickness of the outermost
/// layer, at which an edge still acts on the contact through the first two terms of the pressure ahead of it. At 0.7
/// half-widths, the moment of a roller on a half-plane has an error of up to 5 % (python -m tests.reference.adhesion).
inline constexpr double kLongestZone = 0.7;

}  // namespace viscoroll::detail
