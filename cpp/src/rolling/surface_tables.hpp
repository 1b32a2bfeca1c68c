/// @file
/// @brief What the operators of a surface are made of, kept for the load cases of a model: orders are summed to tables
/// (influence), which are stored here, and make the operator of a window (surface).
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "surface/surface_operator.hpp"
#include "surface/surface_window.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {

/// @brief A mesh that makes more around the contact than can be held.
class MeshTooFine : public std::invalid_argument {
 public:
  /// @param[in] nodes_per_revolution of the mesh
  /// @param[in] most,made what can be held, and what the mesh makes
  MeshTooFine(int nodes_per_revolution, const std::string& most, const std::string& made)
      : std::invalid_argument("mesh.nodes_per_revolution must be coarse enough for " + most + ", got " +
                              std::to_string(nodes_per_revolution) + " (it makes " + made + ")") {}
};

/// @brief Threads may share it: tables are summed under a lock, and never change.
class SurfaceTables {
 public:
  virtual ~SurfaceTables() = default;

  /// @return the surface on the nodes of a window; these tables must outlive it
  /// @throws MeshTooFine where tables would be too large
  [[nodiscard]] virtual std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                           const Formulation& formulation,
                                                                           const Execution& execution) const = 0;
};

}  // namespace viscoroll::detail
