/// @file
/// @brief What all load cases at one speed on one mesh share: the tables of both surfaces, and what follows from their
/// compliance.
#pragma once

#include <memory>

#include "influence/coating_sum.hpp"
#include "rolling/rolling_pair.hpp"
#include "rolling/shared_starts.hpp"

namespace viscoroll::detail {

/// @brief Radii of the free surfaces of two that turn, per those at rest.
struct Swelling {
  double own = 1.0;  ///< of what rolls
  double counterpart = 1.0;

  /// @return drop and slope of the counterpart where a node of what rolls meets it, per those where it would at rest:
  /// the node has moved out along the surface, which bends less (docs/theory/inertia.md)
  [[nodiscard]] double met() const { return own * own / counterpart; }
  friend bool operator==(const Swelling&, const Swelling&) = default;
};

/// @brief Two bodies at a speed on a mesh. Threads may share it.
struct MeshModel {
  RollingPair pair;
  double angular_speed;  ///< Omega [rad/s]
  Mesh mesh;
  Curvature curvature;                               ///< what is kept of it in the equations of the layers
  std::unique_ptr<const SurfaceTables> own;          ///< of what rolls, none where that is rigid
  std::unique_ptr<const SurfaceTables> counterpart;  ///< of what it rolls on, likewise
  double stiffest_modulus;  ///< the largest shear modulus of a layer at the highest harmonic [Pa]
  double centrifugal;       ///< d_R^(c) of both [m]
  Swelling swelling;        ///< that makes of their radii
  double collocation;       ///< where displacements are taken, see `SurfaceOperator::collocation` [spacings]
  std::shared_ptr<SharedStarts> starts = std::make_shared<SharedStarts>();  ///< of its load cases with friction
};

/// @param[in] pair what rolls, and what it rolls on
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacing and truncation
/// @param[in] curvature what is kept of it in the equations of the layers
/// @param[in] execution of this
/// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia
/// @throws std::invalid_argument for bad input and critical speeds
[[nodiscard]] MeshModel make_model(const RollingPair& pair, double angular_speed, const Mesh& mesh, Curvature curvature,
                                   const Execution& execution, double inertia_tolerance = kInertiaTolerance);

}  // namespace viscoroll::detail
