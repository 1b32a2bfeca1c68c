/// @file
/// @brief From the compliance of all orders to influence tables on the surface, theory.md section 4.
///
/// With patches alike at every node the compliance is translation invariant on the (phi, theta) torus, so one table per
/// entry serves all pairs of nodes. The orders of `order_bands.hpp` are summed along theta, then along phi, as products
/// of small matrices; no transform of the whole sphere is taken.
#pragma once

#include <memory>
#include <vector>

#include "influence/order_bands.hpp"
#include "influence/table_sum.hpp"
#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Orders as they are seen from another place than the equator of a sphere, above the degrees that
/// `sphere_sum.hpp` sums by themselves.
struct LocalMetric {
  double sine = 1.0;          ///< sin(theta): order m has the wave number m / sine along phi
  double exact_degree = 0.0;  ///< middle of the step up to which wave numbers are left out; 0 leaves none out
};

/// @brief What the tables of a coating on a mesh are summed from.
class OrderSum : public TableSum {
 public:
  /// @param[in] sphere core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings and truncation
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @param[in] curvature how much of it the equations keep
  /// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia
  /// @throws std::invalid_argument for bad input and critical speeds
  OrderSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int threads, Watch& watch,
           Curvature curvature = Curvature::sphere, double inertia_tolerance = kInertiaTolerance);

  /// @brief The same with other orders than those of the mesh.
  OrderSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, std::vector<OrderBand> phi_bands,
           std::vector<OrderBand> theta_bands, int threads, Watch& watch, Curvature curvature = Curvature::sphere,
           const LocalMetric& metric = {}, double inertia_tolerance = kInertiaTolerance);

  /// @brief The high orders in another metric, with the membrane stiffness of a sphere. Forces are per area of the
  /// equator's metric.
  OrderSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, const LocalMetric& metric, int threads,
           Watch& watch);

  [[nodiscard]] const HarmonicCoating& coating() const { return coating_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const override;

 private:
  Mesh mesh_;
  std::vector<OrderBand> phi_bands_;
  std::vector<OrderBand> theta_bands_;
  LocalMetric metric_;
  HarmonicCoating coating_;
  std::unique_ptr<Spectrum> spectrum_;
};

}  // namespace viscoroll::detail
