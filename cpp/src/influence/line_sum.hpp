/// @file
/// @brief Influence tables of line contact, from the compliance of the orders m alone (docs/theory/rollers.md).
#pragma once

#include <vector>

#include "base/parallel.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "influence/table.hpp"
#include "influence/waves.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Sum over orders for forces per unit length on the patches of a row of nodes along the path. Its tables have a
/// single column.
class LineSum : public TableSum {
 public:
  /// @param[in] bands bands of orders, see `order_bands.hpp`
  /// @param[in] body body at the orders of all bands, one band after the other
  /// @param[in] mesh spacing; work in power tables is per radian of the body that the mesh belongs to
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
