/// @file
/// @brief The ordinary differential equations of one order in one layer, in real form.
///
/// Theory.md section 3 writes z' = B z, z = (u_r, u_phi, u_theta, r sigma_rr, r sigma_rphi, r sigma_rtheta), ' = d/d ln
/// r, with a = lambda / (lambda + 2 mu), b = mu / (lambda + 2 mu), gamma = mu (3a + 2b) and epsilon = mu (a + b). Two
/// observations make it short:
///
/// - With the tangential components written as i times new unknowns, u_phi = i v_phi, sigma_rphi = i tau_phi and so on,
///   every imaginary unit drops out: the matrix is real where the moduli are, and the compliance is symmetric.
/// - Since a + 2b = 1, the displacements enter through t = m v_phi + n v_theta - 2 u_r alone, but for a term k^2 mu v,
///   on a sphere (k^2 - 2) mu v (`membrane_stiffness`):
///
///       u_r'    = a t + (b/mu) s            s'       = -2 gamma t + (1 - 4b) s + m tau_phi + n tau_theta
///       v_phi'  = v_phi - m u_r + tau_phi/mu         tau_phi'  = m (gamma t - a s) + k^2 mu v_phi - 2 tau_phi
///       v_theta' = v_theta - n u_r + tau_theta/mu    tau_theta' = n (gamma t - a s) + k^2 mu v_theta - 2 tau_theta
///
///   with s = r sigma_rr, gamma = mu (3 - 4b) and k^2 = m^2 + n^2.
///
/// Everything in this folder uses that form; `to_physical` undoes it. Orders need not be whole numbers here.
#pragma once

#include <Eigen/Core>

#include "modal/medium.hpp"

namespace viscoroll::detail {

template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;

/// @brief The equations of a layer without inertia, as the product B z.
template <class Scalar>
class LayerEquations {
 public:
  /// @param[in] medium the layer, its modulus in the unit of the stresses
  /// @param[in] m,n order
  LayerEquations(const Medium<Scalar>& medium, double m, double n)
      : m_(m),
        n_(n),
        a_(1.0 - 2.0 * medium.b),
        recovery_(1.0 - 4.0 * medium.b),
        radial_(medium.b / medium.mu),
        tangential_(1.0 / medium.mu),
        gamma_(medium.mu * (3.0 - 4.0 * medium.b)),
        membrane_(membrane_stiffness(medium.curvature, m * m + n * n) * medium.mu) {}

  /// @brief B z for several states at once.
  /// @param[in] z one state in each row: u_r, v_phi, v_theta, s, tau_phi, tau_theta
  template <int States>
  [[nodiscard]] Eigen::Array<Scalar, States, 6> operator()(const Eigen::Array<Scalar, States, 6>& z) const {
    const auto u = z.col(0);
    const auto v_phi = z.col(1);
    const auto v_theta = z.col(2);
    const auto s = z.col(3);
    const auto tau_phi = z.col(4);
    const auto tau_theta = z.col(5);
    using Column = Eigen::Array<Scalar, States, 1>;
    const Column t = m_ * v_phi + n_ * v_theta - 2.0 * u;
    const Column gamma_t = gamma_ * t;
    const Column shear = gamma_t - a_ * s;
    Eigen::Array<Scalar, States, 6> rate;
    rate.col(0) = a_ * t + radial_ * s;
    rate.col(1) = v_phi - m_ * u + tangential_ * tau_phi;
    rate.col(2) = v_theta - n_ * u + tangential_ * tau_theta;
    rate.col(3) = recovery_ * s - 2.0 * gamma_t + m_ * tau_phi + n_ * tau_theta;
    rate.col(4) = m_ * shear + membrane_ * v_phi - 2.0 * tau_phi;
    rate.col(5) = n_ * shear + membrane_ * v_theta - 2.0 * tau_theta;
    return rate;
  }

 private:
  double m_, n_;
  Scalar a_, recovery_, radial_, tangential_, gamma_, membrane_;
};

/// @brief B without inertia as a matrix.
template <class Scalar>
[[nodiscard]] Matrix6<Scalar> elastic_matrix(const Medium<Scalar>& medium, double m, double n) {
  const Eigen::Array<Scalar, 6, 6> unit_states = Matrix6<Scalar>::Identity().array();
  return LayerEquations<Scalar>(medium, m, n)(unit_states).matrix().transpose();
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
