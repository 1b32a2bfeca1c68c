/// @file
/// @brief What a contact with friction would do were its conditions the same everywhere: inverse symbols.
#pragma once

#include <Eigen/Core>

#include "influence/inverse_convolution.hpp"
#include "influence/spectral_product.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Inverse symbols on the doubled window, for all steps on one window.
class StickSlipPreconditioner {
 public:
  explicit StickSlipPreconditioner(const SurfaceOperator& surface);

  /// @param[in] displacement of every node [m]
  /// @return forces that would bring it about [N]
  [[nodiscard]] VectorField force(const VectorField& displacement) const;

  /// @brief Symbol of the inverse of (1 - kappa) + kappa c D C, D the difference from the upstream neighbor and C the
  /// mean compliance along the plane: what turns the traction of a slipping node.
  /// @param[in] rigidity kappa, in (0, 1)
  /// @param[in] scale c [N/m]
  [[nodiscard]] ComplexBuffer turning_symbol(double rigidity, double scale) const;

  /// @return a field multiplied by a symbol
  [[nodiscard]] Eigen::ArrayXd apply(const ComplexBuffer& symbol, const Eigen::ArrayXd& field) const;

 private:
  const SurfaceOperator& surface_;
  InverseConvolution inverse_;
  SpectralProduct product_;
  ComplexBuffer slip_compliance_;  // of D C
};

}  // namespace viscoroll::detail
