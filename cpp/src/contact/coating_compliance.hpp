/// @file
/// @brief The coating as the contact sees it: what nodal forces along x, y and z do to the surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "contact/surface_window.hpp"
#include "influence/convolution.hpp"
#include "parallel.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {

/// @brief Vectors at the nodes of a window: a row for each node, with columns x, y and z.
using VectorField = Eigen::ArrayX3d;

/// @brief Column of a `VectorField`.
enum Axis : Eigen::Index { kForward = 0, kDown = 1, kSideways = 2 };

/// @brief Which terms of C_r = Q^T C_s Q are kept, and how patches are loaded.
struct Formulation {
  Compliance compliance;
  PatchLoad patch_load;
  bool tangential;  ///< whether forces along the plane occur
};

/// @brief Tables that the compliance of a formulation is made of.
[[nodiscard]] std::vector<TableRequest> required_tables(const Formulation& formulation);

/// @brief C_r = Q^T C_s Q over the nodes of a window: rotations around translation-invariant tables. With the radial
/// compliance Q is taken as it is at the lowest point, where y is r, x is -phi and z is -theta.
class CoatingCompliance {
 public:
  /// @param[in] formulation as for `required_tables`
  /// @param[in] window nodes
  /// @param[in] tables for the requests of `required_tables`, reaching across the window
  CoatingCompliance(const Formulation& formulation, const SurfaceWindow& window,
                    std::shared_ptr<const std::vector<Table>> tables);

  [[nodiscard]] WindowShape shape() const { return shape_; }

  /// @return displacement along r by unit forces along r: what dominates the vertical compliance [m/N]
  [[nodiscard]] const Table& radial_table() const { return tables_->front(); }

  /// @param[in] force on every node [N]
  /// @return displacement of every node [m]
  [[nodiscard]] VectorField displacement(const VectorField& force) const;

  /// @brief Work lost per radian of turning [N m]: the sum over all orders of -(2 pi r_o)^2 m Im(conj(s)^T C s),
  /// theory.md section 5. It uses neither the geometry of the contact nor the displacements.
  [[nodiscard]] double lost_work(const VectorField& force) const;

  /// @brief Part of the matrix.
  /// @param[in] targets displaced nodes
  /// @param[in] sources loaded nodes
  /// @param[in] axes of displacements and forces, one or all three
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return [m/N], row a * targets.size() + t, column b * sources.size() + s for the a-th and b-th axis
  [[nodiscard]] Eigen::MatrixXd block(std::span<const Eigen::Index> targets, std::span<const Eigen::Index> sources,
                                      std::span<const Axis> axes, int threads, Watch& watch) const;

 private:
  /// Forces by component and patch shape, a column for each.
  [[nodiscard]] Eigen::ArrayXXd load_components(const VectorField& force) const;

  /// Displacements (r, phi, theta) by unit forces on one node, column component * axes.size() + axis of the force.
  [[nodiscard]] Eigen::ArrayXXd moved_components(std::span<const Eigen::Index> targets, Eigen::Index source,
                                                 std::span<const Axis> axes) const;

  WindowShape shape_;
  std::shared_ptr<const std::vector<Table>> tables_;
  std::vector<ConvolutionTerm> displacement_terms_;        // from loaded components to displaced components
  std::vector<std::array<Eigen::ArrayXd, 3>> directions_;  // [component][axis]
  std::vector<Eigen::ArrayXd> weights_;                    // of the patch shapes
  Convolution displacements_;
  Convolution lost_work_;
};

}  // namespace viscoroll::detail
