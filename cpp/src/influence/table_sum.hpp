/// @file
/// @brief Interface of the sums over orders that give influence tables, for any body.
#pragma once

#include <vector>

#include "base/parallel.hpp"
#include "influence/table.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Contents of a table.
struct TableRequest {
  Entry entry = Entry::rr;  ///< direction of displacement and load
  int source_shape = 0;     ///< Legendre degree of the loaded patch
  /// If false, displacement at the node. If true, its derivative in phi, averaged over a patch of Legendre degree
  /// `receiver_shape`; with nodal forces on both sides this gives the dissipated power per radian.
  bool power = false;
  int receiver_shape = 0;
  /// Distance downstream of the node at which displacement is evaluated [spacings], in [0, 1/2].
  double phi_shift = 0.0;

  friend bool operator==(const TableRequest&, const TableRequest&) = default;
};

/// @brief Provides the tables of a body on a mesh.
class TableSum {
 public:
  virtual ~TableSum() = default;

  /// @brief Sum all orders to tables.
  /// @param[in] requests contents of the tables
  /// @param[in] phi_reach,theta_reach largest offsets, at most half the nodes per revolution
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one table per request
  [[nodiscard]] virtual std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach,
                                                  int theta_reach, int threads, Watch& watch) const = 0;
};

}  // namespace viscoroll::detail
