/// @file
/// @brief Sums over the orders of a coated sphere, and of a coated plane.
#pragma once

#include <utility>
#include <vector>

#include "influence/synthesis.hpp"
#include "modal/harmonic_plane.hpp"
#include "modal/medium.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief What the tables of a coated sphere on a mesh are summed from.
class CoatingSum : public TableSum {
 public:
  /// @param[in] sphere core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings and truncation
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @param[in] curvature how much of it the equations keep
  /// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia
  /// @throws std::invalid_argument for bad input and critical speeds
  CoatingSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int threads, Watch& watch,
             Curvature curvature = Curvature::sphere, double inertia_tolerance = kInertiaTolerance);

  /// @brief The same with other orders than those of the mesh.
  CoatingSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, std::vector<OrderBand> phi_bands,
             const std::vector<OrderBand>& theta_bands, int threads, Watch& watch,
             Curvature curvature = Curvature::sphere, const LocalMetric& metric = {},
             double inertia_tolerance = kInertiaTolerance);

  /// @brief The high orders in another metric, with the membrane stiffness of a sphere. Forces are per area of the
  /// equator's metric.
  CoatingSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, const LocalMetric& metric, int threads,
             Watch& watch);

  [[nodiscard]] const HarmonicCoating& coating() const { return coating_; }
  [[nodiscard]] const Mesh& mesh() const { return sum_.mesh(); }

  /// @brief As `OrderSum::tables`.
  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const override {
    return sum_.tables(requests, phi_reach, theta_reach, threads, watch);
  }

 private:
  HarmonicCoating coating_;
  OrderSum sum_;
};

/// @brief The orders of a plane over which something rolls, on the mesh of what rolls.
/// @param[in] plane layers and base, not rigid
/// @param[in] angular_speed Omega [rad/s], > 0: the plane's material passes at Omega times the radius
/// @param[in] radius of what rolls [m], > 0, at which the mesh's angles are arcs
/// @param[in] mesh spacings, without truncation
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @throws std::invalid_argument for bad input and critical speeds
[[nodiscard]] OrderSum plane_sum(const CoatedPlane& plane, double angular_speed, double radius, const Mesh& mesh,
                                 int threads, Watch& watch);

}  // namespace viscoroll::detail
