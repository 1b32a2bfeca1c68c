/// @file
/// @brief Orders of the tractions on the surface.
///
/// Loads that are symmetric about the middle plane (r and phi even in n, theta odd in n) and antisymmetric loads do not
/// couple in the layers. Orders n >= 0 of both parts are therefore sufficient.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

#include "interior/depth_transfer.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Symmetric (same) or antisymmetric (opposite) about the middle plane.
enum class Mirror : std::size_t { same, opposite };

/// @brief Surface stresses r sigma of given tractions at a grid of orders, not necessarily whole.
class LoadSpectrum {
 public:
  /// @param[in] tractions tractions on the surface
  /// @param[in] metric metric of the body
  /// @param[in] m,n orders >= 0
  LoadSpectrum(const Tractions& tractions, const Metric& metric, const Eigen::ArrayXd& m, const Eigen::ArrayXd& n);

  /// Stresses in the real form, rows m by columns n.
  using Orders = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  /// Stresses of each symmetry and component; empty if there are no such loads.
  using Stresses = std::array<std::array<Orders, 3>, 2>;

  /// @param[in] stresses surface stresses r sigma of all orders
  explicit LoadSpectrum(Stresses stresses);

  /// @return whether there are loads of this symmetry
  [[nodiscard]] bool has(Mirror mirror) const { return present_[static_cast<std::size_t>(mirror)]; }
  /// @return whether each component is loaded
  [[nodiscard]] const LoadedComponents& loaded() const { return loaded_; }
  /// @brief Return the loads of the i-th order m at the orders n.
  [[nodiscard]] LoadRows loads(Mirror mirror, Eigen::Index i) const;

 private:
  /// Leave out a symmetry whose loads are only round-off.
  void find_present();

  Stresses orders_;  // [mirror][component]
  std::array<bool, 2> present_{};
  LoadedComponents loaded_{};
  Eigen::Index count_ = 0;  // number of orders n
};

/// @param[in] tractions tractions
/// @param[in] radius radius of the surface [m], which defines its orders
/// @return grid of the tractions
[[nodiscard]] SurfaceGrid grid_of(const Tractions& tractions, double radius);

/// @param[in] tractions tractions
/// @param[in] radius radius of the surface [m], which defines its orders
/// @return nodes of the tractions
[[nodiscard]] SurfaceWindow window_of(const Tractions& tractions, double radius);

/// @brief Check tractions.
/// @param[in] tractions tractions
/// @throws InvalidInput for values of the wrong count or out of range
void validate(const Tractions& tractions);

}  // namespace viscoroll::detail
