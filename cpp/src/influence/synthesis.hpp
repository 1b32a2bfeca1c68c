/// @file
/// @brief From the compliance of all orders to influence tables on the surface, theory.md section 4.
///
/// With patches alike at every node the compliance is translation invariant on the (phi, theta) torus, so one table per
/// entry serves all pairs of nodes. The orders of `order_bands.hpp` are summed along theta, then along phi, as products
/// of small matrices; no transform of the whole sphere is taken.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "influence/order_bands.hpp"
#include "influence/table.hpp"
#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief What a table holds.
struct TableRequest {
  Entry entry = Entry::rr;  ///< direction of displacement and load
  int source_shape = 0;     ///< Legendre degree of the loaded patch
  /// Displacement at the node where false; where true, its derivative in phi, averaged over a patch of Legendre
  /// degree `receiver_shape`: with nodal forces on both sides, the power lost per radian.
  bool power = false;
  int receiver_shape = 0;
  double phi_shift = 0.0;  ///< where displacement is taken, downstream of the node [spacings], in [0, 1/2]

  friend bool operator==(const TableRequest&, const TableRequest&) = default;
};

/// @brief Orders as they are seen from another place than the equator of a sphere, above the degrees that
/// `sphere_sum.hpp` sums by themselves.
struct LocalMetric {
  double sine = 1.0;          ///< sin(theta): order m has the wave number m / sine along phi
  double exact_degree = 0.0;  ///< middle of the step up to which wave numbers are left out; 0 leaves none out
};

/// @brief What the tables of a surface on a mesh are summed from, whatever body it is of.
class OrderSum {
 public:
  /// @param[in] mesh spacings
  /// @param[in] radius that makes wave numbers orders [m]
  /// @param[in] phi_bands,theta_bands the orders m and n
  /// @param[in] spectrum of all orders m, one band after the other, and up to the highest n
  /// @param[in] metric where the orders count. Forces are per area of the equator's metric.
  OrderSum(const Mesh& mesh, double radius, std::vector<OrderBand> phi_bands, std::vector<OrderBand> theta_bands,
           std::unique_ptr<Spectrum> spectrum, const LocalMetric& metric = {})
      : mesh_(mesh),
        radius_(radius),
        phi_bands_(std::move(phi_bands)),
        theta_bands_(std::move(theta_bands)),
        metric_(metric),
        spectrum_(std::move(spectrum)) {}

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// @brief Sum all orders into tables.
  /// @param[in] requests what to sum
  /// @param[in] phi_reach,theta_reach largest offsets, at most half of the nodes per revolution
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one table for each request
  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const;

 private:
  Mesh mesh_;
  double radius_;
  std::vector<OrderBand> phi_bands_;
  std::vector<OrderBand> theta_bands_;
  LocalMetric metric_;
  std::unique_ptr<Spectrum> spectrum_;
};

}  // namespace viscoroll::detail
