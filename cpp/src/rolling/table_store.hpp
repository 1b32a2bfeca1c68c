/// @file
/// @brief Influence tables of a body whose compliance is translation invariant.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "influence/table.hpp"
#include "rolling/surface_tables.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Purpose of influence tables.
enum class TableKind {
  displacement,  ///< those of `displacement_tables`
  forward,       ///< displacements along the path under forces along the normal
  dissipation,   ///< those of `dissipation_tables`
};

/// @brief Influence tables of a body, reused from an earlier load case if they reach far enough.
class TableStore final : public SurfaceTables {
 public:
  /// @param[in] sum computes the tables
  /// @param[in] mesh mesh whose revolution limits the reach of the tables
  /// @param[in] has_losses whether tables of the dissipation will probably be needed
  TableStore(std::unique_ptr<const TableSum> sum, const Mesh& mesh, bool has_losses)
      : sum_(std::move(sum)), mesh_(mesh), has_losses_(has_losses) {}

  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const override;
  [[nodiscard]] Eigen::ArrayXd forward_displacement(const SurfaceWindow& nodes, const Formulation& formulation,
                                                    const std::vector<Eigen::Index>& displaced,
                                                    const VectorField& force,
                                                    const Execution& execution) const override;

 private:
  struct TableSet {
    Formulation formulation;
    TableKind kind;
    int phi_reach;
    int theta_reach;
    TableOperator::Tables tables;
  };

  /// @param[in] formulation formulation of the contact
  /// @param[in] kind purpose of the tables
  /// @param[in] phi_reach,theta_reach offsets that they reach at least
  /// @param[in] execution threads, progress and cancellation
  [[nodiscard]] TableOperator::Tables tables(const Formulation& formulation, TableKind kind, int phi_reach,
                                             int theta_reach, const Execution& execution) const;
  /// Sum the tables of some kinds together and store them.
  void add(const Formulation& formulation, std::span<const TableKind> kinds, int phi_reach, int theta_reach,
           const Execution& execution) const;
  [[nodiscard]] const TableSet* find(const Formulation& formulation, TableKind kind) const;

  std::unique_ptr<const TableSum> sum_;
  Mesh mesh_;
  bool has_losses_;
  mutable std::timed_mutex mutex_;
  mutable std::vector<TableSet> sets_;  // the widest one for each formulation and kind
};

}  // namespace viscoroll::detail
