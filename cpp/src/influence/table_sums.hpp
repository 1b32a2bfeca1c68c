/// @file
/// @brief Influence tables of a layered body, summed over its orders: over the orders (m, n) in point contact, and over
/// the orders m alone in line contact (docs/theory/rollers.md).
#pragma once

#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "influence/synthesis.hpp"
#include "influence/table.hpp"
#include "influence/waves.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Sum over orders from which the tables of a layered body on a mesh are made. On a plane the mesh is that of
/// the rolling body, whose angles are arcs at the radius of the plane's metric.
class CoatingSum : public TableSum {
 public:
  /// @param[in] body layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings and truncation (not on a plane); work in power tables is per radian of the rolling
  /// body
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @param[in] inertia_tolerance relative error of the compliance up to which inertia may be neglected
  /// @throws InvalidInput for invalid input and critical speeds
  CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, int threads, Watch& watch,
             double inertia_tolerance = kInertiaTolerance);

  /// @brief Same with given orders instead of those of the mesh.
  CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, std::vector<OrderBand> phi_bands,
             const std::vector<OrderBand>& theta_bands, int threads, Watch& watch, const LocalMetric& metric = {},
             double inertia_tolerance = kInertiaTolerance);

  /// @brief High orders of a sphere in another metric. A force is divided by the area that its patch has at the
  /// equator.
  CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, const LocalMetric& metric,
             int threads, Watch& watch);

  [[nodiscard]] const Mesh& mesh() const { return sum_.mesh(); }

  /// @brief Same as `OrderSum::tables`.
  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const override {
    return sum_.tables(requests, phi_reach, theta_reach, threads, watch);
  }

 private:
  OrderSum sum_;
};

/// @brief Sum over orders for forces per unit length on the patches of a row of nodes along the path. Its tables have a
/// single column.
class LineSum : public TableSum {
 public:
  /// @param[in] bands bands of orders, see `order_bands.hpp`
  /// @param[in] body body at the orders of all bands, one band after the other
  /// @param[in] mesh spacing; work in power tables is per radian of the rolling body
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  LineSum(std::vector<OrderBand> bands, const HarmonicBody& body, const MeshOnBody& mesh, int threads, Watch& watch);
  /// @param[in] bands bands of orders
  /// @param[in] spectrum compliance of every order of all bands, in the real form of layer_system.hpp [m/Pa]
  /// @param[in] radius radius that converts wave numbers to orders [m]
  /// @param[in] mesh spacing
  LineSum(std::vector<OrderBand> bands, std::vector<Eigen::Matrix3cd> spectrum, double radius, const MeshOnBody& mesh);

  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const override;

 private:
  [[nodiscard]] Table table(const TableRequest& request, int phi_reach, const std::vector<Waves>& waves) const;

  std::vector<OrderBand> bands_;
  std::vector<Eigen::Matrix3cd> spectrum_;  // compliance of every order [m/Pa]
  double radius_;
  MeshOnBody mesh_;
};

}  // namespace viscoroll::detail
