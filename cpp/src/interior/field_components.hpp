/// @file
/// @brief Components of displacement, stress and strain from the state at a place.
///
/// A state contains u_r, v_phi, v_theta and the stresses on the surface r = const, r sigma = (s, tau_phi, tau_theta).
/// The other stresses follow from the strains along the surface. The formulas of docs/theory/inside.md do not divide by
/// b = (1 - 2 nu) / (2 (1 - nu)), which is 0 in an incompressible medium.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <complex>

#include "modal/layer_stack.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Components in the order of `InteriorFields::values`.
enum Component : std::size_t {
  kDisplacement = 0,  ///< r, phi, theta
  kStress = 3,        ///< rr, phiphi, thetatheta, rphi, rtheta, phitheta
  kStrain = 9,        ///< same order as the stresses
};

/// @return whether the component is i times its real form: displacements along phi and theta, and the components rphi
/// and rtheta of stress and strain
[[nodiscard]] constexpr bool is_imaginary(std::size_t component) {
  constexpr std::array<bool, kFieldComponents> kImaginary{false, true,  true,  false, false, false, true, true,
                                                          false, false, false, false, true,  true,  false};
  return kImaginary[component];
}

/// @return whether the component changes sign with theta under mirror-symmetric loads
[[nodiscard]] constexpr bool is_odd_in_theta(std::size_t component) {
  constexpr std::array<bool, kFieldComponents> kOdd{false, false, true,  false, false, false, false, true,
                                                    true,  false, false, false, false, true,  true};
  return kOdd[component];
}

/// @brief Fields of one m and many n in the real form, one row per component.
using ComponentRows = Eigen::Array<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Rows from which all components follow with factors that do not depend on n: the state and three rows that
/// depend on n.
enum Basis : Eigen::Index {
  kState = 0,
  kSpread = 6,  ///< m v_phi + n v_theta - p u_r, minus the change of area; p = 2 on a sphere, 1 on a cylinder or wheel,
                ///< 0 on a plane
  kShape = 7,  ///< half the difference of the strains along phi and theta: c (n v_theta - m v_phi) / 2, plus u_r / 2 on
               ///< a cylinder or wheel; c^2 is the membrane stiffness per k^2
  kTwist = 8,  ///< -c (m v_theta + n v_phi), twice the strain phitheta
  kBasisRows = 9,
};

/// @return whether a row of the basis is i times its real form
[[nodiscard]] constexpr bool is_imaginary(Basis row) {
  constexpr std::array<bool, kBasisRows> kImaginary{false, true, true, false, true, true, false, false, false};
  return kImaginary[static_cast<std::size_t>(row)];
}

/// @return whether a row of the basis changes sign with theta under mirror-symmetric loads
[[nodiscard]] constexpr bool is_odd_in_theta(Basis row) {
  constexpr std::array<bool, kBasisRows> kOdd{false, false, true, false, false, true, false, false, true};
  return kOdd[static_cast<std::size_t>(row)];
}

/// @brief Compute the basis of all components.
/// @param[in] metric metric of the body
/// @param[in] position position along the normal [m]
/// @param[in] m,n orders
/// @param[in] state rows u_r, v_phi, v_theta, s, tau_phi, tau_theta; one column per n
/// @param[out] basis kBasisRows rows
inline void field_basis(const Metric& metric, double position, double m, const Eigen::ArrayXd& n,
                        const ComponentRows& state, ComponentRows& basis) {
  using Row = Eigen::Array<std::complex<double>, 1, Eigen::Dynamic>;
  const Eigen::Array<double, 1, Eigen::Dynamic> across = metric.shrinkage(position) * n.transpose();
  // The membrane stiffness applies to the part of the tangential strain that does not change the area.
  const Eigen::Array<double, 1, Eigen::Dynamic> k2 = m * m + across.square();
  const Eigen::Array<double, 1, Eigen::Dynamic> membrane = k2.unaryExpr(
      [&](double square) { return square > 0.0 ? std::sqrt(metric.membrane_stiffness(square) / square) : 1.0; });
  const auto orders = across.cast<std::complex<double>>();
  const Row along_phi = m * state.row(1);
  const Row along_theta = orders * state.row(2);
  basis.resize(kBasisRows, n.size());
  basis.topRows(6) = state;
  basis.row(kSpread) = along_phi + along_theta - metric.curved_axes() * state.row(0);
  basis.row(kShape) = 0.5 * membrane * (along_theta - along_phi);
  if (!metric.is_sphere()) basis.row(kShape) += 0.5 * metric.curved_axes() * state.row(0);
  basis.row(kTwist) = -membrane * (m * state.row(2) + orders * state.row(1));
}

/// @brief Compute all components from their basis.
/// @param[in] medium medium at the place
/// @param[in] length length of a radian there [m], by which the stresses of a state are multiplied
/// @param[in] basis kBasisRows rows, or sums of them over n
/// @param[out] fields kFieldComponents rows
inline void components_of(const Medium<std::complex<double>>& medium, double length, const ComponentRows& basis,
                          ComponentRows& fields) {
  using Row = Eigen::Array<std::complex<double>, 1, Eigen::Dynamic>;
  const std::complex<double> mu = medium.mu;
  const std::complex<double> b = medium.b;
  const std::complex<double> a = 1.0 - 2.0 * b;
  const auto s = basis.row(3);
  const auto t = basis.row(kSpread);
  const auto shape = basis.row(kShape);
  const Row area = -0.5 * t;  // half the change of area
  const double per_length = 1.0 / length;

  fields.resize(static_cast<Eigen::Index>(kFieldComponents), basis.cols());
  fields.topRows(3) = basis.topRows(3);
  const Row mean = a * s - 2.0 * a * mu * t;
  fields.row(kStress) = per_length * s;
  fields.row(kStress + 1) = per_length * (mean + 2.0 * mu * (area + shape));
  fields.row(kStress + 2) = per_length * (mean + 2.0 * mu * (area - shape));
  fields.row(kStress + 3) = per_length * basis.row(4);
  fields.row(kStress + 4) = per_length * basis.row(5);
  fields.row(kStress + 5) = per_length * mu * basis.row(kTwist);
  fields.row(kStrain) = per_length * (a * t + b / mu * s);
  fields.row(kStrain + 1) = per_length * (area + shape);
  fields.row(kStrain + 2) = per_length * (area - shape);
  fields.row(kStrain + 3) = per_length / (2.0 * mu) * basis.row(4);
  fields.row(kStrain + 4) = per_length / (2.0 * mu) * basis.row(5);
  fields.row(kStrain + 5) = 0.5 * per_length * basis.row(kTwist);
}

/// @brief Compute all components from a state.
/// @param[in] layers layers of the body
/// @param[in] place position and layer
/// @param[in] m,n orders
/// @param[in] state rows u_r, v_phi, v_theta, s, tau_phi, tau_theta; one column per n
/// @param[out] fields kFieldComponents rows
inline void field_components(const LayerStack<std::complex<double>>& layers, const Place& place, double m,
                             const Eigen::ArrayXd& n, const ComponentRows& state, ComponentRows& fields) {
  ComponentRows basis;
  field_basis(layers.metric, place.position, m, n, state, basis);
  components_of(layers.media[static_cast<std::size_t>(place.layer)], layers.metric.length(place.position), basis,
                fields);
}

}  // namespace viscoroll::detail
