/// @file
/// @brief Compliance of the surface at many orders: a recursion carries it outwards through the layers, and a
/// correction of first order adds the effect of the crown of a tread.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "modal/layer_system.hpp"
#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// Largest exponent of a step due to the order. Up to this exponent the Taylor terms hardly cancel.
inline constexpr double kStepExponent = 4.0;

/// Largest relative increase of the radius in a step. The radius of convergence of the series is 1.
inline constexpr double kStepRatio = 0.25;

/// Largest exponent of a step if shear waves are shorter than the wave of the order. The kMaxTerms Taylor terms of
/// layer_step.cpp sum it to round-off.
inline constexpr double kWaveExponent = 20.0;

/// @brief An order and the layers with their moduli at this order.
template <class Scalar>
struct OrderInLayers {
  const LayerStack<Scalar>& layers;
  double m;  ///< order along, any sign, not necessarily a whole number
  double n;  ///< order across; 0 in plane strain
};

/// @brief Surface compliance of many orders (m, n): displacement per surface stress, in the real form of
/// layer_system.hpp.
///
/// Let d = Y (r sigma), with Y = 0 at a rigid core and the closed form of Y at a half-space. Each step replaces Y by
/// (T11 Y + T12)(T21 Y + T22)^-1, where T is the transition matrix of a step that is short enough to keep all digits. T
/// is never formed: its product with (Y; I) is the Taylor series of the solution about the inner end of the step.
/// Material deeper than 24 e-folds changes the surface by exp(-48) and is neglected.
/// @param[in] orders orders whose layers have the same boundaries; neighbors are solved together, which is fastest if
/// their m^2 + n^2 are similar
/// @param[out] compliances one for each order [m/Pa]
template <class Scalar>
void surface_compliances(std::span<const OrderInLayers<Scalar>> orders, std::span<Matrix3<Scalar>> compliances);

/// @brief Surface compliance of one order.
/// @return compliance [m/Pa]
template <class Scalar>
[[nodiscard]] Matrix3<Scalar> surface_compliance(const LayerStack<Scalar>& layers, double m, double n);

/// @brief Check whether the static stiffness of every order is positive through all layers, i.e. whether no order has a
/// resonance below this speed.
/// @param[in] orders orders with real moduli
[[nodiscard]] bool are_subcritical(std::span<const OrderInLayers<double>> orders);

/// @brief State at one depth per r sigma at the surface. The rows are u_r, v_phi, v_theta [m], s, tau_phi and tau_theta
/// [N/m]; the columns are s, tau_phi and tau_theta at the surface [N/m].
using DepthState = Eigen::Matrix<std::complex<double>, 6, 3>;

/// @brief States inside the layers, in the real form of layer_system.hpp.
///
/// Every outward step of the recursion inverts F = T21 Y + T22, the stresses at its outer end per stress at its inner
/// end. The stored inverses carry the surface stresses down again, f = F^-1 f_outer and u = Y f. They decrease with
/// depth, so that nothing overflows. Below 36 e-folds the state is 0. See docs/theory/inside.md.
/// @param[in] orders orders whose layers have the same boundaries
/// @param[out] states for each order, at the inner boundary of the innermost layer and at the outer boundary of each
/// layer
void depth_states(std::span<const OrderInLayers<std::complex<double>>> orders,
                  std::span<std::vector<DepthState>> states);

extern template void surface_compliances(std::span<const OrderInLayers<double>>, std::span<Matrix3<double>>);
extern template void surface_compliances(std::span<const OrderInLayers<std::complex<double>>>,
                                         std::span<Matrix3<std::complex<double>>>);
extern template Matrix3<double> surface_compliance(const LayerStack<double>&, double, double);
extern template Matrix3<std::complex<double>> surface_compliance(const LayerStack<std::complex<double>>&, double,
                                                                 double);

/// @brief Surface compliance of many orders of layers that may have a crown.
///
/// The equations of a wheel contain the curvature of the surface along the path, not that across it. To first order
/// both curvatures add up, and the curvature across by itself is that of a cylinder whose axis lies along the path
/// (docs/theory/wheels.md). A crown therefore adds `crown.proportion` times C_cylinder - C_plane, at the same wave
/// numbers and moduli, where the cylinder is curved across. This difference is without inertia, which would change it
/// in second order.
/// @param[in] orders orders as in `surface_compliances`; those of a wheel if there is a crown
/// @param[in] crown crown of the wheel, or a flat one
/// @param[out] compliances one for each order [m/Pa]
template <class Scalar>
void crowned_compliances(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown,
                         std::span<Matrix3<Scalar>> compliances);

extern template void crowned_compliances(std::span<const OrderInLayers<double>>, const Crown&,
                                         std::span<Matrix3<double>>);
extern template void crowned_compliances(std::span<const OrderInLayers<std::complex<double>>>, const Crown&,
                                         std::span<Matrix3<std::complex<double>>>);

}  // namespace viscoroll::detail
