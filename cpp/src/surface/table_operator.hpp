/// @file
/// @brief Surfaces whose compliance is translation invariant in phi and theta, apart from rotations.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "influence/synthesis.hpp"
#include "influence/table_product.hpp"
#include "surface/surface_operator.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Terms of C_r = Q^T C_s Q in use, and the traction on a patch.
struct Formulation {
  Compliance compliance;
  PatchLoad patch_load;
  bool tangential;           ///< whether tangential forces occur
  double collocation = 0.0;  ///< see `SurfaceOperator::collocation` [spacings]
  /// Whether the surface is that of the counterbody. Its frame is the mirror image of the rolling body's, so that
  /// forces and displacements along it keep their signs; its normals turn only by its curvatures. It has radial
  /// compliance and flat patches.
  bool is_counterbody = false;
  Curvatures counterbody_curvatures = {};

  friend bool operator==(const Formulation&, const Formulation&) = default;
};

/// @brief Tables needed for the displacements of a formulation, that of r by r first.
[[nodiscard]] std::vector<TableRequest> displacement_tables(const Formulation& formulation);

/// @brief Tables needed for the work dissipated in the body.
[[nodiscard]] std::vector<TableRequest> dissipation_tables(const Formulation& formulation);

/// @return [component][axis] at every node, with components r, phi and theta, or r alone: load along a component per
/// force along an axis
[[nodiscard]] std::vector<std::array<WindowField, 3>> load_directions(const Formulation& formulation,
                                                                      const SurfacePoints& points);

/// @return [shape][column] fraction of the load of a node that its patch carries in the shape of a Legendre polynomial
[[nodiscard]] std::vector<Eigen::ArrayXd> patch_weights(const Formulation& formulation, const SurfacePoints& points);

/// @brief Compliance C_r = Q^T C_s Q on the nodes of a window: translation-invariant tables between rotations.
/// With the radial compliance, Q is that of the lowest point, where y is r, x is -phi and z is -theta, except that
/// tangential forces press with their component along r, and u_r moves the surface along the plane.
class TableOperator : public SurfaceOperator {
 public:
  using Tables = std::shared_ptr<const std::vector<Table>>;
  /// Function that returns the tables of `dissipation_tables`, called when the dissipated work is computed.
  using DissipationSource = std::function<Tables(int phi_reach, int theta_reach)>;

  /// @param[in] formulation same as in `displacement_tables`
  /// @param[in] grid,window nodes
  /// @param[in] tables tables of `displacement_tables`, which reach across the window
  /// @param[in] dissipation_source tables of the dissipated work
  /// @param[in] execution threads and progress of this and of all products
  /// @param[in] period period of periodic tables, which reach over it, at least the window [nodes]; empty if the tables
  /// are not periodic
  TableOperator(const Formulation& formulation, const SurfaceGrid& grid, const Window& window, Tables tables,
                DissipationSource dissipation_source, const Execution& execution,
                std::optional<WindowShape> period = std::nullopt);

  [[nodiscard]] const Window& window() const override { return window_; }
  [[nodiscard]] const Execution& execution() const override { return execution_; }
  [[nodiscard]] std::optional<WindowShape> period() const override { return period_; }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override;
  [[nodiscard]] Deforming deforming() const override {
    return formulation_.is_counterbody ? Deforming::counterbody : Deforming::rolling;
  }
  [[nodiscard]] double row_distance() const override { return grid_.radius * grid_.phi_spacing; }
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override;
  [[nodiscard]] std::optional<Eigen::MatrixXd> normal_compliance(
      const std::vector<Eigen::Index>& displaced, const std::vector<Eigen::Index>& loaded) const override;
  /// Coarser mesh: a patch of twice the width covers a whole patch and half of each neighbor, so its tables are
  /// averages of tables. Its patches are flat. It is periodic if the period contains an even number of nodes and the
  /// window is the whole period.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override;
  [[nodiscard]] const LocalCompliance& local() const override { return local_; }
  [[nodiscard]] double collocation() const override { return formulation_.collocation; }
  [[nodiscard]] bool takes_mirrored() const override;
  [[nodiscard]] double operations() const override;
  /// Dissipated work: the sum over all orders of -(2 pi r_o)^2 m Im(conj(s)^T C s), docs/theory/normal-contact.md.
  [[nodiscard]] Losses dissipation(const VectorField& force) const override;

 private:
  /// Load along a component and in a patch shape, due to forces along x, y and z; `field` is component * shapes +
  /// shape.
  [[nodiscard]] double load(const VectorField& force, Eigen::Index row, Eigen::Index column, std::size_t field) const;
  [[nodiscard]] std::size_t fields() const { return local_.directions.size() * weights_.size(); }
  /// Created on first use: most windows that contain boxes never need the product.
  [[nodiscard]] const Convolution& spectral_displacements() const;
  [[nodiscard]] VectorField displacement(const VectorField& force, const Convolution& product) const;
  /// @return displacements by sums over the loaded nodes; empty if transforms take less time
  [[nodiscard]] std::optional<VectorField> displacement_by_nodes(const VectorField& force) const;
  /// Rows of a product, from a column on: loads due to forces, and displacements due to results.
  [[nodiscard]] SpectralProduct::Fill loads(const VectorField& force, Eigen::Index middle) const;
  [[nodiscard]] SpectralProduct::Take moves(VectorField& result, Eigen::Index middle) const;
  /// Whether each component of mirror-symmetric forces is odd in theta.
  [[nodiscard]] std::vector<bool> odd_components() const;

  Formulation formulation_;
  SurfaceGrid grid_;
  Window window_;
  Tables tables_;
  DissipationSource dissipation_source_;
  LocalCompliance local_;
  std::vector<Eigen::ArrayXd> weights_;  // weights of the patch shapes
  TableProduct by_nodes_;                // product for windows with few loaded nodes
  mutable std::optional<Convolution> displacements_;
  Execution execution_;
  std::optional<WindowShape> period_;
};

}  // namespace viscoroll::detail
