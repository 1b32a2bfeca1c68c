/// @file
/// @brief Stiffness of a ring-shaped element with nine nodes at an order m around the axis.
///
/// Displacements (u_r, u_phi, u_z) = (U, i V, W) e^(i m phi), U, V and W biquadratic in the section, and with them
///
///     eps_rr = U_r             eps_phiphi = (U - m V)/r      eps_zz = W_z
///     gamma_rphi = i (V_r + (m U - V)/r)   gamma_phiz = i (V_z + m W/r)   gamma_rz = U_z + W_r :
///
/// every i drops out of the energy, which is real for real moduli. The volumetric part works on the linear part of the
/// volumetric strain in each element, as a pressure that is linear and breaks at its edges would: such pairs are stable
/// without compressibility (D. Boffi, F. Brezzi, M. Fortin, Mixed Finite Element Methods and Applications, 2013,
/// section 8.6.3).
#pragma once

#include <Eigen/Core>
#include <array>

namespace viscoroll::detail {

constexpr Eigen::Index kElementNodes = 9;
constexpr Eigen::Index kElementUnknowns = 3 * kElementNodes;  ///< U, V and W of the first node, of the second ...

using ElementMatrix = Eigen::Matrix<double, kElementUnknowns, kElementUnknowns>;

/// @brief A matrix with one term for each power of m: 0, 1 and 2.
using PowersOfOrder = std::array<ElementMatrix, 3>;

/// @brief The stiffness is mu shear + lambda volumetric, per radian [m].
struct ElementStiffness {
  PowersOfOrder shear;       ///< with the deviator and the mean of the strain
  PowersOfOrder volumetric;  ///< with the change of volume, squared
};

/// @param[in] r,z nodes [m], 3 along the first coordinate (z) for each of 3 along the second (r)
/// @return the element's matrices
[[nodiscard]] ElementStiffness element_stiffness(const std::array<double, kElementNodes>& r,
                                                 const std::array<double, kElementNodes>& z);

/// @return value of a matrix at an order m
[[nodiscard]] ElementMatrix at_order(const PowersOfOrder& powers, double m);

/// @brief Quadratic polynomials through the ends and the middle of an edge.
/// @param[in] x place on it, in [-1, 1]
/// @return the share of the first end, the middle and the other end
[[nodiscard]] std::array<double, 3> quadratic_shares(double x);

}  // namespace viscoroll::detail
