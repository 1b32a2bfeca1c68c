/// @file
/// @brief What loads of one order m and many orders n make at places inside the layers.
///
/// At a given m every entry of the states is a smooth function of n^2, times n where it is odd: a few dozen solutions
/// of the layers give them as Chebyshev series in ln(m^2 + n^2), for all n.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "interior/field_components.hpp"
#include "interior/layer_cuts.hpp"
#include "modal/chebyshev_panels.hpp"

namespace viscoroll::detail {

/// @brief Surface stresses r sigma of one m and many n in the real form, rows s, tau_phi, tau_theta.
using LoadRows = Eigen::Array<std::complex<double>, 3, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Which components are loaded at all.
using LoadedComponents = std::array<bool, 3>;

/// @brief The layers' answer to order m at the cuts.
class DepthTransfer {
 public:
  /// @param[in] layers media at order m, from the center outwards
  /// @param[in] cuts where states are wanted; the surface is always one of the boundaries
  /// @param[in] boundaries those of them that are wanted
  /// @param[in] m order
  /// @param[in] highest_n largest n that is asked for
  /// @param[in] loaded components of the surface stress that are not zero
  /// @param[in] tolerance of the series, relative to the load for stresses and to the largest displacement
  DepthTransfer(std::span<const Medium<std::complex<double>>> layers, const LayerCuts& cuts,
                std::vector<std::size_t> boundaries, double m, double highest_n, const LoadedComponents& loaded,
                double tolerance);

  /// @brief Series at a list of orders.
  /// @param[in] n orders, ascending from 0
  void evaluate(const Eigen::ArrayXd& n);

  /// @brief The state at a boundary under given loads.
  /// @param[in] boundary place in the list of those that are wanted
  /// @param[in] n the first orders of those that were evaluated
  /// @param[in] loads on the surface
  /// @param[out] state rows u_r, v_phi, v_theta, s, tau_phi, tau_theta
  void state(std::size_t boundary, const Eigen::ArrayXd& n, const LoadRows& loads, ComponentRows& state) const;

 private:
  using Entries = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void append(const std::vector<Medium<std::complex<double>>>& pieces, double low, double high);
  [[nodiscard]] Entries solve(const std::vector<Medium<std::complex<double>>>& pieces,
                              std::span<const double> squares) const;
  [[nodiscard]] bool is_resolved(const Panel<std::complex<double>>& panel) const;

  std::vector<std::size_t> boundaries_;
  double m_;
  double tolerance_;
  std::vector<std::size_t> columns_;  // loaded components
  std::vector<Panel<std::complex<double>>> panels_;
  Entries values_;  // [boundary][component][column] by n
};

}  // namespace viscoroll::detail
