/// @file
/// @brief Change of the compliance of a tread due to its crown, to first order in the curvature.
///
/// The equations of a wheel contain the curvature of the surface along the path, not that across it. To first order
/// both curvatures add up, and the curvature across by itself is that of a cylinder whose axis lies along the path
/// (docs/theory/wheels.md).
#pragma once

#include <complex>
#include <span>

#include "modal/compliance_recursion.hpp"
#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief Add `crown.proportion` times C_cylinder - C_plane, at the same wave numbers and moduli, where the cylinder is
/// curved across.
///
/// The difference is without inertia, which would change it in second order.
/// @param[in] orders orders (m, n) in the layers of a wheel
/// @param[in] crown crown of the wheel, not flat
/// @param[in,out] compliances compliances of these orders [m/Pa]
template <class Scalar>
void add_crown(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown,
               std::span<Matrix3<Scalar>> compliances);

extern template void add_crown(std::span<const OrderInLayers<double>>, const Crown&, std::span<Matrix3<double>>);
extern template void add_crown(std::span<const OrderInLayers<std::complex<double>>>, const Crown&,
                               std::span<Matrix3<std::complex<double>>>);

}  // namespace viscoroll::detail
