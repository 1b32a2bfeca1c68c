/// @file
/// @brief Preconditioner of contact with friction: inverse symbols of its conditions, as if they were the same at all
/// nodes.
#pragma once

#include <Eigen/Core>

#include "influence/spectral_product.hpp"
#include "influence/table_product.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Inverse symbols on the doubled window, for all steps on one window.
class StickSlipPreconditioner {
 public:
  explicit StickSlipPreconditioner(const SurfaceOperator& surface);

  /// @param[in] displacement displacement of every node [m]
  /// @return approximate forces that cause it [N]
  [[nodiscard]] VectorField force(const VectorField& displacement) const;

  /// @brief Return the symbol of the inverse of (1 - kappa) + kappa k_t D C, for the direction of slipping nodes. D is
  /// the difference from the upstream neighbor and C the mean compliance along the plane.
  /// @param[in] rigidity kappa, in (0, 1)
  /// @param[in] scale stiffness k_t [N/m]
  [[nodiscard]] ComplexBuffer turning_symbol(double rigidity, double scale) const;

  /// @return field multiplied by a symbol
  [[nodiscard]] Eigen::ArrayXd apply(const ComplexBuffer& symbol, const Eigen::ArrayXd& field) const;

 private:
  const SurfaceOperator& surface_;
  InverseConvolution inverse_;
  SpectralProduct product_;
  ComplexBuffer slip_compliance_;  // symbol of D C
};

}  // namespace viscoroll::detail
