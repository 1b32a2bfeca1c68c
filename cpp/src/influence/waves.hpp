/// @file
/// @brief Waves of the orders: their values at the offsets of nodes, and their means over the patch of a node.
///
/// In theta the traction on a patch is (1/Delta) times a Legendre polynomial P_p(2 (theta - theta_N) / Delta), whose
/// order n is (-i)^p j_p(n Delta / 2), with the spherical Bessel function j_p; j_0 = sinc is the flat patch (53). The
/// 1/sin(theta) of the patch (38) is a sum of the first three, with weights that depend only on theta of the node; the
/// error is of order (Delta/2)^3.
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/dense_products.hpp"

namespace viscoroll::detail {

/// @brief Cosines and sines of order times offset, one row per order and one column per offset.
struct Waves {
  RowMajorMatrix cosines;
  RowMajorMatrix sines;
};

/// @param[in] orders orders, not necessarily integers
/// @param[in] spacing spacing of the offsets, which start at 0 [rad]
/// @param[in] last_offset number of spacings to the largest offset
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, double spacing, int last_offset);

/// @param[in] orders orders, not necessarily integers
/// @param[in] offsets any offsets [rad]
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, const Eigen::ArrayXd& offsets);

constexpr int kPatchShapes = 3;  ///< Legendre degrees 0, 1, 2

/// @return sin(x) / x
[[nodiscard]] double sinc(double x);

/// @return spherical Bessel function j_p(x) of degree p in {0, 1, 2}
[[nodiscard]] double spherical_bessel(int degree, double x);

/// @brief Legendre coefficients of 1/sin(theta) on [theta - spacing/2, theta + spacing/2].
/// @param[in] theta center of the patch [rad], more than spacing/2 away from 0 and pi
/// @param[in] spacing width of the patch [rad]
[[nodiscard]] std::array<double, kPatchShapes> spherical_patch_weights(double theta, double spacing);

}  // namespace viscoroll::detail
