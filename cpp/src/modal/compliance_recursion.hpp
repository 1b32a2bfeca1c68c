/// @file
/// @brief The compliance of the surface, carried outwards through the layers.
#pragma once

#include <span>

#include "modal/layer_system.hpp"

namespace viscoroll::detail {

/// @brief An order with the layers as it sees them.
template <class Scalar>
struct OrderInLayers {
  std::span<const Medium<Scalar>> media;  ///< core outwards
  double m;                               ///< of either sign, not necessarily whole
  double n;
};

/// @brief Surface compliance of many orders (m, n): displacement per surface stress, in the real form of
/// layer_system.hpp.
///
/// With d = Y (r sigma), Y = 0 at the rigid core, each step takes Y to (T11 Y + T12)(T21 Y + T22)^-1, the transition
/// matrix T of a step being short enough to keep all digits. T itself is never formed: its product with (Y; I) is the
/// Taylor series of the solution about the step's inner radius. Material deeper than 24 / k in ln r changes the
/// surface by exp(-48), and is left out; with inertia, depth counts less by the slower decay of shear waves.
/// @param[in] orders all with layers of the same radii; neighbors are solved side by side, best with like m^2 + n^2
/// @param[out] compliances one for each [m/Pa]
template <class Scalar>
void surface_compliances(std::span<const OrderInLayers<Scalar>> orders, std::span<Matrix3<Scalar>> compliances);

/// @brief The same for one order.
template <class Scalar>
[[nodiscard]] Matrix3<Scalar> surface_compliance(std::span<const Medium<Scalar>> media, double m, double n);

/// @brief Whether every order's static stiffness stays positive through all layers, i.e. no resonance of an order
/// lies below this speed.
/// @param[in] orders with real moduli
[[nodiscard]] bool are_subcritical(std::span<const OrderInLayers<double>> orders);

extern template void surface_compliances(std::span<const OrderInLayers<double>>, std::span<Matrix3<double>>);
extern template void surface_compliances(std::span<const OrderInLayers<std::complex<double>>>,
                                         std::span<Matrix3<std::complex<double>>>);
extern template Matrix3<double> surface_compliance(std::span<const Medium<double>>, double, double);
extern template Matrix3<std::complex<double>> surface_compliance(std::span<const Medium<std::complex<double>>>, double,
                                                                 double);

}  // namespace viscoroll::detail
