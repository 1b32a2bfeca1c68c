/// @file
/// @brief Surfaces whose compliance is translation invariant along phi and theta, but for rotations.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "influence/convolution.hpp"
#include "influence/synthesis.hpp"
#include "influence/table_product.hpp"
#include "surface/curvatures.hpp"
#include "surface/surface_operator.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Which terms of C_r = Q^T C_s Q are kept, and how patches are loaded.
struct Formulation {
  Compliance compliance;
  PatchLoad patch_load;
  bool tangential;           ///< whether forces along the plane occur
  double collocation = 0.0;  ///< see `SurfaceOperator::collocation` [spacings]
  /// Of what a body rolls on. Its frame is the mirror image of the body's, so that forces and displacements
  /// along it keep their signs; its normals turn with its curvatures alone. Radial compliance and flat patches.
  bool is_counterpart = false;
  Curvatures counterpart_curvatures = {};

  friend bool operator==(const Formulation&, const Formulation&) = default;
};

/// @brief Tables that the displacements of a formulation are made of, that of r by r first.
[[nodiscard]] std::vector<TableRequest> displacement_tables(const Formulation& formulation);

/// @brief Tables that the work lost in the body is made of.
[[nodiscard]] std::vector<TableRequest> dissipation_tables(const Formulation& formulation);

/// @return [component][axis] of r, phi and theta, or of r alone, at every node: what forces along the axes load
[[nodiscard]] std::vector<std::array<WindowField, 3>> load_directions(const Formulation& formulation,
                                                                      const SurfacePoints& points);

/// @return [shape] the share of every node's load that its patch bears in the shape of a Legendre polynomial, by column
[[nodiscard]] std::vector<Eigen::ArrayXd> patch_weights(const Formulation& formulation, const SurfacePoints& points);

/// @brief C_r = Q^T C_s Q over the nodes of a window: rotations around translation-invariant tables. With the radial
/// compliance Q is taken as it is at the lowest point, where y is r, x is -phi and z is -theta, but that forces along
/// the plane press with their share of r, and u_r moves the surface along the plane.
class TableOperator : public SurfaceOperator {
 public:
  using Tables = std::shared_ptr<const std::vector<Table>>;
  /// Gives tables for the requests of `dissipation_tables` when the dissipation is asked for.
  using DissipationSource = std::function<Tables(int phi_reach, int theta_reach)>;

  /// @param[in] formulation as for `displacement_tables`
  /// @param[in] grid,window nodes
  /// @param[in] tables for the requests of `displacement_tables`, reaching across the window
  /// @param[in] dissipation_source tables of the dissipation
  /// @param[in] execution of this and of all products
  TableOperator(const Formulation& formulation, const SurfaceGrid& grid, const Window& window, Tables tables,
                DissipationSource dissipation_source, const Execution& execution);

  [[nodiscard]] const Window& window() const override { return window_; }
  [[nodiscard]] const Execution& execution() const override { return execution_; }
  [[nodiscard]] VectorField displacement(const VectorField& force) const override;
  [[nodiscard]] Deforming deforming() const override {
    return formulation_.is_counterpart ? Deforming::counterpart : Deforming::rolling;
  }
  [[nodiscard]] double row_distance() const override { return grid_.radius * grid_.phi_spacing; }
  using SurfaceOperator::normal_displacement;
  [[nodiscard]] Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                    const Eigen::VectorXd& pressing) const override;
  [[nodiscard]] std::optional<Eigen::MatrixXd> normal_compliance(
      const std::vector<Eigen::Index>& displaced, const std::vector<Eigen::Index>& loaded) const override;
  /// Patches of twice the width lie on a whole patch and half of each neighbor, so that tables are averages of tables;
  /// they are flat.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> coarsened() const override;
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> within(const Window& window) const override;
  [[nodiscard]] const LocalCompliance& local() const override { return local_; }
  [[nodiscard]] double collocation() const override { return formulation_.collocation; }
  [[nodiscard]] bool takes_mirrored() const override;
  [[nodiscard]] double operations() const override;
  /// The sum over all orders of -(2 pi r_o)^2 m Im(conj(s)^T C s), docs/theory/normal-contact.md.
  [[nodiscard]] Losses dissipation(const VectorField& force) const override;

 private:
  /// Of forces along x, y and z, that along a component and in a shape, field being component * shapes + shape.
  [[nodiscard]] double load(const VectorField& force, Eigen::Index row, Eigen::Index column, std::size_t field) const;
  [[nodiscard]] std::size_t fields() const { return local_.directions.size() * weights_.size(); }
  /// Products are made when they are asked for: of the windows that boxes lie in, most never are.
  [[nodiscard]] const Convolution& spectral_displacements() const;
  [[nodiscard]] VectorField displacement(const VectorField& force, const Convolution& product) const;
  /// @return nothing where transforms take less time
  [[nodiscard]] std::optional<VectorField> displacement_by_nodes(const VectorField& force) const;
  /// Rows of a product from a column on: what forces load, and what it moves.
  [[nodiscard]] SpectralProduct::Fill loads(const VectorField& force, Eigen::Index middle) const;
  [[nodiscard]] SpectralProduct::Take moves(VectorField& result, Eigen::Index middle) const;
  /// Whether each component of mirrored forces is odd in theta.
  [[nodiscard]] std::vector<bool> odd_components() const;

  Formulation formulation_;
  SurfaceGrid grid_;
  Window window_;
  Tables tables_;
  DissipationSource dissipation_source_;
  LocalCompliance local_;
  std::vector<Eigen::ArrayXd> weights_;  // of the patch shapes
  TableProduct by_nodes_;                // of windows few nodes of which are loaded
  mutable std::optional<Convolution> displacements_;
  Execution execution_;
};

}  // namespace viscoroll::detail
