/// @file
/// @brief Tables from which the operators of a surface are built, kept for the load cases of a model. `influence` sums
/// the orders to tables, this module stores them, and `surface` builds the operator of a window from them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "surface/surface_operator.hpp"
#include "surface/surface_window.hpp"
#include "surface/table_operator.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {

/// @brief Error for a mesh whose nodes or tables do not fit into memory.
class MeshTooFine : public InvalidInput {
 public:
  /// @param[in] nodes_per_revolution number of the rejected mesh
  /// @param[in] most,made largest possible amount, and the amount that the mesh needs
  MeshTooFine(int nodes_per_revolution, const std::string& most, const std::string& made)
      : InvalidInput("mesh.nodes_per_revolution", "must be so small that the mesh needs at most " + most,
                     std::to_string(nodes_per_revolution) + " (" + made + ")") {}
};

/// @brief Tables of one surface. Threads may share it: tables are summed under a lock and never change.
class SurfaceTables {
 public:
  virtual ~SurfaceTables() = default;

  /// @return the operator of the surface on the nodes of a window; these tables must outlive it
  /// @throws MeshTooFine if the tables would be too large
  [[nodiscard]] virtual std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                           const Formulation& formulation,
                                                                           const Execution& execution) const = 0;

  /// @brief Displacement u_r x/r_o - u_phi of the surface of the rolling body along the path, under forces along the
  /// normals.
  /// @param[in] nodes nodes of a window
  /// @param[in] formulation formulation of the contact, with the radial compliance
  /// @param[in] displaced numbers of nodes
  /// @param[in] force force on every node [N]
  /// @param[in] execution threads, progress and cancellation
  /// @return forward displacement of the displaced nodes [m]
  [[nodiscard]] virtual Eigen::ArrayXd forward_displacement(const SurfaceWindow& nodes, const Formulation& formulation,
                                                            const std::vector<Eigen::Index>& displaced,
                                                            const VectorField& force,
                                                            const Execution& execution) const {
    Formulation tangential = formulation;
    tangential.tangential = true;
    tangential.collocation = 0.0;
    const VectorField moved = operator_on(nodes, tangential, execution)->displacement(force)(displaced, Eigen::all);
    // The operator inclines u_r by the angle rather than by x/r_o; see `load_directions`.
    const Eigen::ArrayXd inclination = nodes.x()(displaced) / nodes.grid().radius;
    return moved.col(kForward) + (inclination - nodes.points().angle_ahead().at(displaced)) * moved.col(kDown);
  }
};

}  // namespace viscoroll::detail
