/// @file
/// @brief Stiffness of a ring-shaped element with nine nodes at an order m around the axis.
///
/// The displacements are (u_r, u_phi, u_z) = (U, i V, W) e^(i m phi), where U, V and W are biquadratic in the section.
/// The strains are
///
///     eps_rr = U_r             eps_phiphi = (U - m V)/r      eps_zz = W_z
///     gamma_rphi = i (V_r + (m U - V)/r)   gamma_phiz = i (V_z + m W/r)   gamma_rz = U_z + W_r .
///
/// Every i drops out of the energy, which is real for real moduli. The volumetric part acts on the linear part of the
/// volumetric strain in each element, which is equivalent to a pressure that is linear in the element and discontinuous
/// at its edges. Such a pair of elements is stable in the incompressible limit (D. Boffi, F. Brezzi, M. Fortin, Mixed
/// Finite Element Methods and Applications, 2013, section 8.6.3).
#pragma once

#include <Eigen/Core>
#include <array>

namespace viscoroll::detail {

constexpr Eigen::Index kElementNodes = 9;
constexpr Eigen::Index kElementUnknowns = 3 * kElementNodes;  ///< U, V and W of the first node, then of the second, ...

using ElementMatrix = Eigen::Matrix<double, kElementUnknowns, kElementUnknowns>;

/// @brief A matrix with one term for each power of m: 0, 1 and 2.
using PowersOfOrder = std::array<ElementMatrix, 3>;

/// @brief Stiffness of an element per radian [m]: mu * shear + lambda * volumetric.
struct ElementStiffness {
  PowersOfOrder shear;       ///< from the square of the strain tensor
  PowersOfOrder volumetric;  ///< from the square of the volumetric strain
};

/// @brief Stiffness matrices of an element.
/// @param[in] r,z coordinates of the nodes [m], 3 along the first coordinate (z) for each of 3 along the second (r)
/// @return the matrices
[[nodiscard]] ElementStiffness element_stiffness(const std::array<double, kElementNodes>& r,
                                                 const std::array<double, kElementNodes>& z);

/// @return value of a matrix at an order m
[[nodiscard]] ElementMatrix at_order(const PowersOfOrder& powers, double m);

/// @brief Quadratic shape functions of an edge.
/// @param[in] x coordinate on the edge, in [-1, 1]
/// @return shape functions of the first end, the middle and the other end
[[nodiscard]] std::array<double, 3> quadratic_shares(double x);

}  // namespace viscoroll::detail
