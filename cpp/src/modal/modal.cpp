// Public functions for single orders.
#include "viscoroll/modal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "base/invalid_speed.hpp"
#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/degree_compliance.hpp"
#include "modal/harmonic_body.hpp"
#include "modal/layer_system.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll {

using cplx = std::complex<double>;
using RowMajor3 = Eigen::Matrix<cplx, 3, 3, Eigen::RowMajor>;
using RowMajor6 = Eigen::Matrix<cplx, 6, 6, Eigen::RowMajor>;

namespace {

/// Magnitudes |m| of the orders along the path.
std::vector<double> magnitudes_of(std::span<const int> m) {
  constexpr int kHighestOrder = 1000000;
  std::vector<double> magnitudes;
  for (const int order : m) {
    detail::require_count("m", order, -kHighestOrder, kHighestOrder);
    magnitudes.push_back(std::abs(order));
  }
  return magnitudes;
}

/// Compliance at the i-th order m of the body, or at -m. The fields are real, so that order (-m, n) is the complex
/// conjugate of order (m, -n).
/// @param[in] is_negative whether the order is -m
ComplexMatrix3 physical_compliance(const detail::HarmonicBody& body, std::size_t i, bool is_negative, double n) {
  const Eigen::Matrix3cd compliance = detail::to_physical(body.compliance({.i = i, .n = is_negative ? -n : n}));
  ComplexMatrix3 matrix;
  Eigen::Map<RowMajor3>(matrix.data()) = is_negative ? compliance.conjugate() : compliance;
  return matrix;
}

}  // namespace

std::vector<ComplexMatrix3> surface_compliance(const CoatedSphere& sphere, double angular_speed, std::span<const int> m,
                                               std::span<const int> n, Curvature curvature, const Observer& observer) {
  detail::require_orders(curvature);
  if (m.size() != n.size()) {
    detail::reject("n", "as long as m (" + std::to_string(m.size()) + ")", std::to_string(n.size()));
  }
  const detail::HarmonicBody body(detail::checked_layered_body(sphere, curvature), angular_speed, magnitudes_of(m));

  detail::Watch watch(observer);
  std::vector<ComplexMatrix3> compliances(m.size());
  detail::parallel_for(m.size(), 0, watch, "solving layers", [&](std::size_t i, const detail::Worker&) {
    compliances[i] = physical_compliance(body, i, m[i] < 0, n[i]);
  });
  return compliances;
}

std::vector<ComplexMatrix3> degree_compliance(const CoatedSphere& sphere, double angular_speed,
                                              std::span<const int> degree, std::span<const int> order,
                                              const Observer& observer) {
  constexpr int kHighestDegree = 1000000;
  if (degree.size() != order.size()) {
    detail::reject("order", "as long as degree (" + std::to_string(degree.size()) + ")", std::to_string(order.size()));
  }
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < degree.size(); ++i) {
    detail::require_count("degree", degree[i], 0, kHighestDegree);
    if (order[i] < -degree[i] || order[i] > degree[i]) {
      detail::reject("order", "at most the degree " + std::to_string(degree[i]) + " in magnitude",
                     std::to_string(order[i]), Range{.minimum = -1.0 * degree[i], .maximum = 1.0 * degree[i]});
    }
    magnitudes.push_back(std::abs(order[i]));
  }
  CoatedSphere still = sphere;
  for (Layer& layer : still.layers) layer.density = 0.0;
  const detail::HarmonicBody body(detail::checked_layered_body(still, Curvature::exact), angular_speed, magnitudes);

  detail::Watch watch(observer);
  std::vector<ComplexMatrix3> compliances(degree.size());
  detail::parallel_for(degree.size(), 0, watch, "solving layers", [&](std::size_t i, const detail::Worker&) {
    const auto c = detail::degree_compliance(body.layers_at(i), degree[i]);
    ComplexMatrix3& matrix = compliances[i];
    matrix = {c.radial, c.mixed, 0.0, c.mixed, c.along, 0.0, 0.0, 0.0, c.across};
    if (order[i] < 0) std::ranges::transform(matrix, matrix.begin(), [](cplx z) { return std::conj(z); });
  });
  return compliances;
}

std::vector<ComplexMatrix3> surface_compliance(const CoatedPlane& plane, double speed, std::span<const double> k_xi,
                                               std::span<const double> k_zeta) {
  if (k_xi.size() != k_zeta.size()) {
    detail::reject("k_zeta", "as long as k_xi (" + std::to_string(k_xi.size()) + ")", std::to_string(k_zeta.size()));
  }
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < k_xi.size(); ++i) {
    detail::require_finite("k_xi", k_xi[i]);
    detail::require_finite("k_zeta", k_zeta[i]);
    if (k_xi[i] == 0.0 && k_zeta[i] == 0.0) detail::reject("k_zeta", "nonzero if k_xi is 0 1/m", "0 1/m");
    magnitudes.push_back(std::abs(k_xi[i]));
  }
  detail::LayeredBody layers = detail::checked_layered_body(plane, 1.0);
  detail::require_positive("speed", speed, "m/s");
  const detail::HarmonicBody body = detail::with_given_speed(
      {"speed", speed, "m/s"}, [&] { return detail::HarmonicBody(std::move(layers), speed, magnitudes); });
  std::vector<ComplexMatrix3> compliances(k_xi.size());
  for (std::size_t i = 0; i < k_xi.size(); ++i) {
    compliances[i] = physical_compliance(body, i, k_xi[i] < 0.0, k_zeta[i]);
  }
  return compliances;
}

std::vector<ComplexMatrix3> surface_compliance(const CoatedWheel& wheel, double angular_speed, std::span<const int> m,
                                               std::span<const double> k) {
  if (m.size() != k.size()) {
    detail::reject("k", "as long as m (" + std::to_string(m.size()) + ")", std::to_string(k.size()));
  }
  for (const double wave_number : k) detail::require_finite("k", wave_number);
  const detail::HarmonicBody body(detail::checked_layered_body(wheel), angular_speed, magnitudes_of(m));
  std::vector<ComplexMatrix3> compliances(m.size());
  for (std::size_t i = 0; i < m.size(); ++i) {
    compliances[i] = physical_compliance(body, i, m[i] < 0, k[i] * body.radius());
  }
  return compliances;
}

ComplexMatrix6 state_matrix(const Layer& layer, double angular_speed, double radius, int m, int n,
                            Curvature curvature) {
  validate(layer);
  detail::require_orders(curvature);
  detail::require_positive("angular_speed", angular_speed, "rad/s");
  detail::require_positive("radius", radius, "m");
  const std::array frequency{std::abs(m) * angular_speed};
  const cplx at_frequency = modulus_in_rolling(layer.shear_modulus, angular_speed, frequency).front();
  const cplx mu = m < 0 ? std::conj(at_frequency) : at_frequency;  // mu*(-w) = conj mu*(w)
  const detail::Medium<cplx> medium{.inner = radius,
                                    .outer = radius,
                                    .mu = mu,
                                    .b = detail::shear_ratio(layer, mu),
                                    .inertia = layer.density * angular_speed * angular_speed};

  detail::Matrix6<cplx> matrix = detail::elastic_matrix({.radius = radius, .curvature = curvature}, medium, m, n);
  matrix.bottomLeftCorner<3, 3>() += (medium.inertia * radius * radius * detail::inertia_matrix(m)).cast<cplx>();
  // Convert the unknowns v = -i u of the tangential components to u.
  const cplx i(0.0, 1.0);
  for (const Eigen::Index k : {1, 2, 4, 5}) {
    matrix.row(k) *= i;
    matrix.col(k) *= -i;
  }
  ComplexMatrix6 result;
  Eigen::Map<RowMajor6>(result.data()) = matrix;
  return result;
}

}  // namespace viscoroll
