/// @file
/// @brief What the lattices of a history share: an elastic coating on a mesh, and how it creeps.
#pragma once

#include <memory>

#include "parallel.hpp"
#include "surface/surface_window.hpp"
#include "transient/creep_spectrum.hpp"
#include "transient/mirrored_tables.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief A coating whose layers share one relaxation function, so that its displacements are those of an elastic one
/// under loads that creep.
struct CreepingCoating {
  SurfaceGrid grid;
  double thickness;        ///< of all layers [m]
  Compliance compliance;   ///< in the contact condition
  double friction;         ///< Coulomb's coefficient [-]
  double driving_force;    ///< on the center, forward [N]
  double mass;             ///< of what moves with the center [kg]
  CreepSpectrum spectrum;  ///< per the compliance at rest
  MirroredTables tables;   ///< at rest
};

/// @brief The creep spectrum that all layers share.
/// @throws std::invalid_argument where they do not, or a bulk modulus makes creep depend on the order
[[nodiscard]] CreepSpectrum common_spectrum(const CoatedSphere& sphere, const TimeRange& range);

/// @brief The coating with every modulus as it is at rest, without inertia.
[[nodiscard]] CoatedSphere coating_without_time(const CoatedSphere& sphere);

}  // namespace viscoroll::detail
