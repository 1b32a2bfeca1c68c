/// @file
/// @brief Influence tables on the surface from the compliance of all orders (docs/theory/influence-tables.md).
///
/// With identical patches at all nodes the compliance is translation invariant on the (phi, theta) torus, so one table
/// for each entry of the compliance serves all pairs of nodes. The orders of `order_bands.hpp` are summed along theta
/// first, then along phi, as products of small matrices. No transform of the whole sphere is taken.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "influence/table.hpp"
#include "influence/theta_sums.hpp"
#include "modal/spectrum.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Sum over orders from which the tables of a surface on a mesh are made, for any body.
class OrderSum : public TableSum {
 public:
  /// @param[in] mesh spacings; work in power tables is per radian of the rolling body
  /// @param[in] radius radius that converts wave numbers to orders [m]
  /// @param[in] phi_bands,theta_bands orders m and n
  /// @param[in] spectrum compliance at all orders m, one band after the other, and up to the highest n
  /// @param[in] metric local metric; a force is divided by the area that its patch has at the equator
  OrderSum(const MeshOnBody& mesh, double radius, std::vector<OrderBand> phi_bands, std::vector<OrderBand> theta_bands,
           std::unique_ptr<Spectrum> spectrum, const LocalMetric& metric = {})
      : mesh_(mesh),
        radius_(radius),
        phi_bands_(std::move(phi_bands)),
        theta_bands_(std::move(theta_bands)),
        metric_(metric),
        spectrum_(std::move(spectrum)) {}

  [[nodiscard]] const Mesh& mesh() const { return mesh_.mesh(); }

  [[nodiscard]] std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                          int threads, Watch& watch) const override;

 private:
  MeshOnBody mesh_;
  double radius_;
  std::vector<OrderBand> phi_bands_;
  std::vector<OrderBand> theta_bands_;
  LocalMetric metric_;
  std::unique_ptr<Spectrum> spectrum_;
};

}  // namespace viscoroll::detail
