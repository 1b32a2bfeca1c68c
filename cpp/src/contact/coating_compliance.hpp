/// @file
/// @brief The coating as the contact sees it: what nodal forces along x, y and z do to the surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "contact/surface_window.hpp"
#include "influence/convolution.hpp"
#include "influence/inverse_convolution.hpp"
#include "influence/synthesis.hpp"
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

  friend bool operator==(const Formulation&, const Formulation&) = default;
};

/// @brief Forces along x, y and z as loads along r, phi and theta by patch shape.
struct LoadComponents {
  LoadComponents(const Formulation& formulation, const SurfaceWindow& window);

  /// @return a column for each component and shape, numbered component * shapes + shape
  [[nodiscard]] Eigen::ArrayXXd of(const VectorField& force) const;

  std::vector<std::array<Eigen::ArrayXd, 3>> directions;  ///< [component][axis]
  std::vector<Eigen::ArrayXd> weights;                    ///< of the patch shapes
};

/// @brief Tables that the displacements of a formulation are made of, that of r by r first.
[[nodiscard]] std::vector<TableRequest> displacement_tables(const Formulation& formulation);

/// @brief Tables that the work lost in the coating is made of.
[[nodiscard]] std::vector<TableRequest> lost_work_tables(const Formulation& formulation);

/// @brief Who computes, and who may stop it.
struct Execution {
  int threads;                          ///< 0 for all cores
  std::reference_wrapper<Watch> watch;  ///< progress and cancellation
};

/// @brief C_r = Q^T C_s Q over the nodes of a window: rotations around translation-invariant tables. With the radial
/// compliance Q is taken as it is at the lowest point, where y is r, x is -phi and z is -theta.
class CoatingCompliance {
 public:
  /// @param[in] formulation as for `displacement_tables`
  /// @param[in] window nodes
  /// @param[in] tables for the requests of `displacement_tables`, reaching across the window
  /// @param[in] execution of this and of all products
  CoatingCompliance(const Formulation& formulation, const SurfaceWindow& window,
                    std::shared_ptr<const std::vector<Table>> tables, const Execution& execution);

  [[nodiscard]] WindowShape shape() const { return shape_; }
  [[nodiscard]] const Execution& execution() const { return execution_; }

  /// @param[in] force on every node [N]
  /// @return displacement of every node [m]
  [[nodiscard]] VectorField displacement(const VectorField& force) const;

  /// @param[in] pressing force on every node, upwards [N]
  /// @return upward displacement of every node [m], at a third of the cost
  [[nodiscard]] Eigen::ArrayXd vertical_displacement(const Eigen::ArrayXd& pressing) const;

  /// @param[in] nodes that carry forces
  /// @param[in] pressing force on each of them, upwards [N]
  /// @return their upward displacements [m]
  [[nodiscard]] Eigen::VectorXd vertical_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const;

  /// @brief Inverse of the tables' convolution for flat patches, on a periodic domain.
  [[nodiscard]] InverseConvolution make_inverse(WindowShape period) const;

  /// @brief Inverse of a single table's convolution, on a periodic domain.
  [[nodiscard]] InverseConvolution make_inverse_of(Entry entry, WindowShape period) const;

  /// @param[in] inverse from `make_inverse`
  /// @param[in] displacement of every node [m]
  /// @return forces that displace the nodes about so, were the window all there is [N]
  [[nodiscard]] VectorField approximate_force(const InverseConvolution& inverse, const VectorField& displacement) const;

  /// @return table of flat patches for an entry of the compliance
  [[nodiscard]] const Table& table(Entry entry) const;

  /// @brief Part of the matrix.
  /// @param[in] targets displaced nodes
  /// @param[in] sources loaded nodes
  /// @param[in] axes of displacements and forces, one or all three
  /// @return [m/N], row a * targets.size() + t, column b * sources.size() + s for the a-th and b-th axis
  [[nodiscard]] Eigen::MatrixXd block(std::span<const Eigen::Index> targets, std::span<const Eigen::Index> sources,
                                      std::span<const Axis> axes) const;

 private:
  /// Displacements (r, phi, theta) by unit forces on one node, column component * axes.size() + axis of the force.
  [[nodiscard]] Eigen::ArrayXXd moved_components(std::span<const Eigen::Index> targets, Eigen::Index source,
                                                 std::span<const Axis> axes) const;

  Formulation formulation_;
  WindowShape shape_;
  std::shared_ptr<const std::vector<Table>> tables_;
  std::vector<ConvolutionTerm> displacement_terms_;  // from loaded components to displaced components
  LoadComponents components_;
  Convolution displacements_;
  Execution execution_;
};

/// @brief Work lost per radian of turning [N m]: the sum over all orders of -(2 pi r_o)^2 m Im(conj(s)^T C s),
/// theory.md section 5. It uses neither the geometry of the contact nor the displacements.
/// @param[in] formulation as for `lost_work_tables`
/// @param[in] window nodes
/// @param[in] tables for the requests of `lost_work_tables`, reaching across the window
/// @param[in] force on every node [N]
/// @param[in] execution of the product
[[nodiscard]] double lost_work(const Formulation& formulation, const SurfaceWindow& window,
                               const std::vector<Table>& tables, const VectorField& force, const Execution& execution);

}  // namespace viscoroll::detail
