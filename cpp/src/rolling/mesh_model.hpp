/// @file
/// @brief Data that load cases share: centrifugal displacements at one speed, and on one mesh also the tables of both
/// surfaces and quantities that follow from their compliance.
#pragma once

#include <memory>

#include "influence/table_sums.hpp"
#include "rolling/rolling_pair.hpp"
#include "rolling/shared_starts.hpp"

namespace viscoroll::detail {

/// @brief Centrifugal growth: ratio of the spinning to the resting surface radius of each body.
struct CentrifugalGrowth {
  double own = 1.0;  ///< of the rolling body
  double counterbody = 1.0;

  /// @return drop and slope of the counterbody where a node of the rolling body meets it, relative to those at rest:
  /// the node has moved outwards along a surface that is less curved (docs/theory/inertia.md)
  [[nodiscard]] double met() const { return own * own / counterbody; }
  friend bool operator==(const CentrifugalGrowth&, const CentrifugalGrowth&) = default;
};

/// @brief Two bodies at a speed. Copies share the bodies.
struct PairAtSpeed : RollingPair {
  double angular_speed = 0.0;  ///< Omega [rad/s]
  double centrifugal = 0.0;    ///< d_R^(c), sum of both bodies [m]
  CentrifugalGrowth growth;    ///< centrifugal growth of both bodies
};

/// @brief Compute the centrifugal displacements of two bodies.
/// @param[in] pair rolling body and counterbody
/// @param[in] angular_speed Omega [rad/s], > 0
/// @throws InvalidInput for critical speeds, and if the rolling body would grow to fill the counterbody
[[nodiscard]] PairAtSpeed at_speed(const RollingPair& pair, double angular_speed);

/// @brief Two bodies at a speed on a mesh. Threads may share it.
struct MeshModel {
  PairAtSpeed pair;
  Mesh mesh;
  Curvature curvature;                               ///< curvature terms retained in the layer equations
  std::unique_ptr<const SurfaceTables> own;          ///< of the rolling body; null if it is rigid
  std::unique_ptr<const SurfaceTables> counterbody;  ///< of the counterbody; null if it is rigid
  double stiffest_modulus;                           ///< largest shear modulus of a layer at the highest harmonic [Pa]
  bool has_losses;                                   ///< whether the dissipation is evaluated
  double collocation;  ///< where displacements are evaluated, see `SurfaceOperator::collocation` [spacings]
  std::shared_ptr<SharedStarts> starts = std::make_shared<SharedStarts>();  ///< of load cases with friction
};

/// @brief Compute the model of two bodies at a speed on a mesh.
/// @param[in] pair rolling body and counterbody at a speed
/// @param[in] mesh spacing and truncation
/// @param[in] curvature curvature terms retained in the layer equations
/// @param[in] execution threads, progress and cancellation
/// @param[in] needs results for which tables are computed
/// @throws InvalidInput for bad input and critical speeds
[[nodiscard]] MeshModel make_model(const PairAtSpeed& pair, const Mesh& mesh, Curvature curvature,
                                   const Execution& execution, const TableNeeds& needs = {});

}  // namespace viscoroll::detail
