/// @file
/// @brief Influence tables of a body whose compliance is translation invariant.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "influence/table_sum.hpp"
#include "rolling/surface_tables.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief What influence tables are for.
enum class TableKind {
  displacement,  ///< those of `displacement_tables`
  dissipation,   ///< those of `dissipation_tables`
};

/// @brief Tables as made for an earlier load case, where that is enough.
class TableStore final : public SurfaceTables {
 public:
  /// @param[in] sum makes tables
  /// @param[in] mesh whose revolution bounds their reach
  TableStore(std::unique_ptr<const TableSum> sum, const Mesh& mesh) : sum_(std::move(sum)), mesh_(mesh) {}

  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const override;

 private:
  struct TableSet {
    Formulation formulation;
    TableKind kind;
    int phi_reach;
    int theta_reach;
    TableOperator::Tables tables;
  };

  /// @param[in] formulation which tables
  /// @param[in] kind which of them
  /// @param[in] phi_reach,theta_reach offsets that they reach at least
  /// @param[in] execution of the sum
  [[nodiscard]] TableOperator::Tables tables(const Formulation& formulation, TableKind kind, int phi_reach,
                                             int theta_reach, const Execution& execution) const;
  /// Sum the tables of some kinds at once, and keep them.
  void add(const Formulation& formulation, std::span<const TableKind> kinds, int phi_reach, int theta_reach,
           const Execution& execution) const;
  [[nodiscard]] const TableSet* find(const Formulation& formulation, TableKind kind) const;

  std::unique_ptr<const TableSum> sum_;
  Mesh mesh_;
  mutable std::timed_mutex mutex_;
  mutable std::vector<TableSet> sets_;  // the widest of each kind
};

}  // namespace viscoroll::detail
