/// @file
/// @brief Sums over the orders of a layered body.
#pragma once

#include <utility>
#include <vector>

#include "influence/synthesis.hpp"
#include "modal/harmonic_body.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief What the tables of a layered body on a mesh are summed from: on a plane that of what rolls, whose angles are
/// arcs at the radius of the plane's metric.
class CoatingSum : public TableSum {
 public:
  /// @param[in] body layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings, and truncation, which a plane cannot have
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia
  /// @throws std::invalid_argument for bad input and critical speeds
  CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, int threads, Watch& watch,
             double inertia_tolerance = kInertiaTolerance);

  /// @brief The same with patches that are no whole part of a revolution.
  /// @param[in] patches on the body; `mesh` is then the nearest one of its own, which orders are chosen for
  CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const Patches& patches, int threads,
             Watch& watch, double inertia_tolerance = kInertiaTolerance);

  /// @brief The same with other orders than those of the mesh.
  CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, std::vector<OrderBand> phi_bands,
             const std::vector<OrderBand>& theta_bands, int threads, Watch& watch);

  /// @brief The high orders of a sphere in another metric. Forces are per area of the equator's metric.
  CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const LocalMetric& metric, int threads,
             Watch& watch);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// @brief As `OrderSum::tables`.
  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const override {
    return sum_.tables(requests, phi_reach, theta_reach, threads, watch);
  }

 private:
  CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const Patches& patches,
             std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads, Watch& watch,
             const LocalMetric& metric, double inertia_tolerance);

  Mesh mesh_;
  OrderSum sum_;
};

}  // namespace viscoroll::detail
