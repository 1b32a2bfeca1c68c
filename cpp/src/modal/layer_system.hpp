/// @file
/// @brief The ordinary differential equations of one order in one layer of a sphere, in real form.
///
/// The equations of docs/theory/layers.md are z' = B z with ' = d/d ln r, a = lambda / (lambda + 2 mu),
/// b = mu / (lambda + 2 mu), gamma = mu (3a + 2b), epsilon = mu (a + b) and
/// z = (u_r, u_phi, u_theta, r sigma_rr, r sigma_rphi, r sigma_rtheta). Two substitutions shorten them:
///
/// - Let the tangential components be i times new unknowns, u_phi = i v_phi, sigma_rphi = i tau_phi, and the same for
///   theta. Every imaginary unit then drops out: the matrix is real if the moduli are, and the compliance is symmetric.
/// - Since a + 2b = 1, the displacements enter only through t = m v_phi + n v_theta - 2 u_r, except for a term
///   k^2 mu v, on a sphere (k^2 - 2) mu v (`membrane_stiffness`):
///
///       u_r'    = a t + (b/mu) s            s'       = -2 gamma t + (1 - 4b) s + m tau_phi + n tau_theta
///       v_phi'  = v_phi - m u_r + tau_phi/mu         tau_phi'  = m (gamma t - a s) + k^2 mu v_phi - 2 tau_phi
///       v_theta' = v_theta - n u_r + tau_theta/mu    tau_theta' = n (gamma t - a s) + k^2 mu v_theta - 2 tau_theta
///
///   with s = r sigma_rr, gamma = mu (3 - 4b) and k^2 = m^2 + n^2.
///
/// All files of this folder use this form; `to_physical` converts back. Orders need not be whole numbers. The equations
/// of other surfaces are in layer_step.hpp.
#pragma once

#include <Eigen/Core>

#include "modal/layer_stack.hpp"

namespace viscoroll::detail {

template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;

/// @brief Matrix B without inertia.
/// @param[in] metric metric of a sphere
/// @param[in] medium layer, with its modulus in the unit of the stresses
/// @param[in] m,n order
template <class Scalar>
[[nodiscard]] Matrix6<Scalar> elastic_matrix(const Metric& metric, const Medium<Scalar>& medium, double m, double n) {
  const Scalar a = 1.0 - 2.0 * medium.b;
  const Scalar gamma = medium.mu * (3.0 - 4.0 * medium.b);
  const Scalar membrane = metric.membrane_stiffness(m * m + n * n) * medium.mu;
  const Eigen::Vector3d spread(-2.0, m, n);   // coefficients of t
  const Eigen::Vector3d turned(0.0, -m, -n);  // coefficients of the gradient of u_r
  Matrix6<Scalar> matrix = Matrix6<Scalar>::Zero();
  auto strain = matrix.template topLeftCorner<3, 3>();
  auto compliance = matrix.template topRightCorner<3, 3>();
  auto stiffness = matrix.template bottomLeftCorner<3, 3>();
  auto stress = matrix.template bottomRightCorner<3, 3>();
  strain.diagonal().template tail<2>().setOnes();
  strain.col(0) += turned.cast<Scalar>();
  strain.row(0) += a * spread.transpose().cast<Scalar>();
  compliance.diagonal() << medium.b / medium.mu, 1.0 / medium.mu, 1.0 / medium.mu;
  stiffness = gamma * (spread * spread.transpose()).cast<Scalar>();
  stiffness.diagonal().template tail<2>().array() += membrane;
  stress.row(0) << 1.0 - 4.0 * medium.b, m, n;
  stress.col(0).template tail<2>() += a * turned.tail<2>().cast<Scalar>();
  stress.diagonal().template tail<2>().array() -= 2.0;
  return matrix;
}

/// @brief Inertial terms of the stress rows of B, per displacement and per rho Omega^2 r^2. They depend on the order m
/// only, because the rotation causes the acceleration. Their sign is that of a load on the material.
[[nodiscard]] inline Eigen::Matrix3d inertia_matrix(double m) {
  const double diagonal = 1.0 + m * m;
  return Eigen::Matrix3d{{-diagonal, 2.0 * m, 0.0}, {2.0 * m, -diagonal, 0.0}, {0.0, 0.0, -m * m}};
}

/// @brief Convert to the components of the paper: u_phi = i v_phi, sigma_rphi = i tau_phi, and the same for theta.
template <class Scalar>
[[nodiscard]] Eigen::Matrix3cd to_physical(const Matrix3<Scalar>& compliance) {
  const std::complex<double> i(0.0, 1.0);
  Eigen::Matrix3cd physical = compliance.template cast<std::complex<double>>();
  physical.row(0).tail<2>() *= -i;
  physical.col(0).tail<2>() *= i;
  return physical;
}

}  // namespace viscoroll::detail
