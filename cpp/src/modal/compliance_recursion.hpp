/// @file
/// @brief The compliance of the surface, carried outwards through the layers.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "modal/layer_system.hpp"

namespace viscoroll::detail {

/// Largest exponent of a step by the order alone: Taylor terms cancel little.
inline constexpr double kStepExponent = 4.0;

/// Largest relative growth of a radius in a step: the radius of convergence of the series is 1.
inline constexpr double kStepRatio = 0.25;

/// Largest exponent of a step where shear waves are shorter than the order: kMaxTerms Taylor terms (layer_step.cpp) sum
/// it to round-off.
inline constexpr double kWaveExponent = 20.0;

/// @brief An order with the layers as it sees them.
template <class Scalar>
struct OrderInLayers {
  const LayerStack<Scalar>& layers;
  double m;  ///< of either sign, not necessarily whole
  double n;  ///< 0 where nothing varies across
};

/// @brief Surface compliance of many orders (m, n): displacement per surface stress, in the real form of
/// layer_system.hpp.
///
/// With d = Y (r sigma), Y = 0 at the rigid core and that of a half-space in closed form, each step takes Y to
/// (T11 Y + T12)(T21 Y + T22)^-1, the transition matrix T of a step being short enough to keep all digits. T itself is
/// never formed: its product with (Y; I) is the Taylor series of the solution about the step's inner end. Material
/// deeper than 24 e-folds changes the surface by exp(-48), and is left out.
/// @param[in] orders all with layers of the same places; neighbors are solved side by side, best with like m^2 + n^2
/// @param[out] compliances one for each [m/Pa]
template <class Scalar>
void surface_compliances(std::span<const OrderInLayers<Scalar>> orders, std::span<Matrix3<Scalar>> compliances);

/// @brief The same for one order.
template <class Scalar>
[[nodiscard]] Matrix3<Scalar> surface_compliance(const LayerStack<Scalar>& layers, double m, double n);

/// @brief Whether every order's static stiffness stays positive through all layers, i.e. no resonance of an order
/// lies below this speed.
/// @param[in] orders with real moduli
[[nodiscard]] bool are_subcritical(std::span<const OrderInLayers<double>> orders);

/// @brief State at one place per r sigma at the surface: rows u_r, v_phi, v_theta [m], s, tau_phi, tau_theta [N/m], a
/// column for each of s, tau_phi and tau_theta there [N/m].
using DepthState = Eigen::Matrix<std::complex<double>, 6, 3>;

/// @brief States inside the layers, in the real form of layer_system.hpp.
///
/// On its way outwards every step of the recursion inverts F = T21 Y + T22, the stresses at its outer end per stresses
/// at its inner one. Kept, these inverses take the stresses at the surface down again, f = F^-1 f_outer and u = Y f:
/// they fall with depth, so nothing overflows. Below 36 e-folds the state is 0. See docs/theory/inside.md.
/// @param[in] orders all with layers of the same places
/// @param[out] states for each order, at the inner boundary of the innermost layer and at the outer one of each
void depth_states(std::span<const OrderInLayers<std::complex<double>>> orders,
                  std::span<std::vector<DepthState>> states);

extern template void surface_compliances(std::span<const OrderInLayers<double>>, std::span<Matrix3<double>>);
extern template void surface_compliances(std::span<const OrderInLayers<std::complex<double>>>,
                                         std::span<Matrix3<std::complex<double>>>);
extern template Matrix3<double> surface_compliance(const LayerStack<double>&, double, double);
extern template Matrix3<std::complex<double>> surface_compliance(const LayerStack<std::complex<double>>&, double,
                                                                 double);

}  // namespace viscoroll::detail
