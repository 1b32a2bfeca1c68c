/// @file
/// @brief Influence tables from the compliance of all orders, whatever body has it.
#pragma once

#include <vector>

#include "influence/table.hpp"
#include "modal/spectrum.hpp"
#include "parallel.hpp"

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

/// @brief Gives the tables of a body on a mesh.
class TableSum {
 public:
  virtual ~TableSum() = default;

  /// @brief Sum all orders into tables.
  /// @param[in] requests what to sum
  /// @param[in] phi_reach,theta_reach largest offsets, at most half of the nodes per revolution
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one table for each request
  [[nodiscard]] virtual std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach,
                                                  int theta_reach, int threads, Watch& watch) const = 0;
};

}  // namespace viscoroll::detail
