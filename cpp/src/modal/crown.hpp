/// @file
/// @brief What the crown of a wheel changes in the compliance of its tread, to the first order in its curvature.
///
/// The equations of a wheel know that its surface is a ring along the path, not that it is one across. In the first
/// order both curvatures add up, and the other one by itself is a cylinder whose axis lies along the path
/// (docs/theory/wheels.md).
#pragma once

#include <complex>
#include <span>

#include "modal/compliance_recursion.hpp"
#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief Add C_cylinder - C_plane, at the same wave numbers and moduli, the cylinder curved across, as often as the
/// crown says. Without inertia, which would change this difference in the second order.
/// @param[in] orders (m, n) in the layers of a wheel
/// @param[in] crown of the wheel, not flat
/// @param[in,out] compliances of these orders [m/Pa]
template <class Scalar>
void add_crown(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown,
               std::span<Matrix3<Scalar>> compliances);

extern template void add_crown(std::span<const OrderInLayers<double>>, const Crown&, std::span<Matrix3<double>>);
extern template void add_crown(std::span<const OrderInLayers<std::complex<double>>>, const Crown&,
                               std::span<Matrix3<std::complex<double>>>);

}  // namespace viscoroll::detail
