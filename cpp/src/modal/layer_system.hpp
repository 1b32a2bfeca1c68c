/// @file
/// @brief The ordinary differential equations of one order in one layer, in real form.
///
/// Theory.md section 3 writes z' = B z, z = (u_r, u_phi, u_theta, r sigma_rr, r sigma_rphi, r sigma_rtheta), ' = d/d ln
/// r. With the tangential components written as i times new unknowns, u_phi = i v_phi, sigma_rphi = i tau_phi and so
/// on, every imaginary unit drops out: the matrix is real where the moduli are, and the compliance is symmetric.
/// Everything in this folder uses that form; `to_physical` undoes it. Orders need not be whole numbers here.
#pragma once

#include <Eigen/Core>

#include "modal/medium.hpp"

namespace viscoroll::detail {

template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;

/// @brief B without inertia. Constant over a layer; stresses in units of `stress_unit`.
template <class Scalar>
[[nodiscard]] Matrix6<Scalar> elastic_matrix(const Medium<Scalar>& medium, double m, double n, double stress_unit) {
  const Scalar mu = medium.mu / stress_unit;
  const Scalar a = medium.a;
  const Scalar b = medium.b;
  const Scalar gamma = mu * (3.0 * a + 2.0 * b);
  const Scalar epsilon = mu * (a + b);
  const Scalar zero(0.0);
  const Scalar one(1.0);
  Matrix6<Scalar> matrix;
  matrix << -2.0 * a, m * a, n * a, b / mu, zero, zero,                                               //
      Scalar(-m), one, zero, zero, one / mu, zero,                                                    //
      Scalar(-n), zero, one, zero, zero, one / mu,                                                    //
      4.0 * gamma, -2.0 * m * gamma, -2.0 * n * gamma, one - 4.0 * b, Scalar(m), Scalar(n),           //
      -2.0 * m * gamma, 4.0 * m * m * epsilon + n * n * mu, m * n * gamma, -m * a, Scalar(-2), zero,  //
      -2.0 * n * gamma, m * n * gamma, 4.0 * n * n * epsilon + m * m * mu, -n * a, zero, Scalar(-2);
  return matrix;
}

/// @brief What inertia adds to the stress rows of B, from the displacements, per rho Omega^2 r^2: order m alone counts,
/// since it is the turning that accelerates. The sign is that of a load on the material.
[[nodiscard]] inline Eigen::Matrix3d inertia_matrix(double m) {
  const double diagonal = 1.0 + m * m;
  return Eigen::Matrix3d{{-diagonal, 2.0 * m, 0.0}, {2.0 * m, -diagonal, 0.0}, {0.0, 0.0, -m * m}};
}

/// @brief Back to the components of the paper: u_phi = i v_phi, sigma_rphi = i tau_phi, and the same for theta.
template <class Scalar>
[[nodiscard]] Eigen::Matrix3cd to_physical(const Matrix3<Scalar>& compliance) {
  const std::complex<double> i(0.0, 1.0);
  Eigen::Matrix3cd physical = compliance.template cast<std::complex<double>>();
  physical.row(0).tail<2>() *= -i;
  physical.col(0).tail<2>() *= i;
  return physical;
}

}  // namespace viscoroll::detail
