/// @file
/// @brief The orders of the tractions on the surface.
///
/// Loads that are mirror images of themselves in the middle plane, r and phi even and theta odd in n, and those that
/// are the opposite of their images keep to themselves in the layers. Orders n >= 0 of each are all there is to know.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "interior/depth_transfer.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Mirror images of themselves, or opposite to them.
enum class Mirror : std::size_t { same, opposite };

/// @brief Surface stresses r sigma of given tractions at a grid of orders, not necessarily whole.
class LoadSpectrum {
 public:
  /// @param[in] tractions of the plane
  /// @param[in] metric of the body
  /// @param[in] m,n orders >= 0
  LoadSpectrum(const Tractions& tractions, const Metric& metric, const Eigen::ArrayXd& m, const Eigen::ArrayXd& n);

  /// @return whether there are loads of this kind
  [[nodiscard]] bool has(Mirror mirror) const { return present_[static_cast<std::size_t>(mirror)]; }
  /// @return which components are loaded
  [[nodiscard]] const LoadedComponents& loaded() const { return loaded_; }
  /// @brief Loads of the i-th order m at the orders n.
  [[nodiscard]] LoadRows loads(Mirror mirror, Eigen::Index i) const;

 private:
  using Orders = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::array<std::array<Orders, 3>, 2> orders_;  // [mirror][component], m by n; empty where there are none
  std::array<bool, 2> present_{};
  LoadedComponents loaded_{};
  Eigen::Index count_;  // of orders n
};

/// @return their grid, on a surface whose orders are per this radius [m]
[[nodiscard]] SurfaceGrid grid_of(const Tractions& tractions, double radius);

/// @return the nodes of the tractions on it
[[nodiscard]] SurfaceWindow window_of(const Tractions& tractions, double radius);

/// @brief Check tractions.
/// @throws std::invalid_argument
void validate(const Tractions& tractions);

}  // namespace viscoroll::detail
