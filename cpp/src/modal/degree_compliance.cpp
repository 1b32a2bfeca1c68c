#include "modal/degree_compliance.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "modal/compliance_recursion.hpp"
#include "modal/layer_stack.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using std::numbers::sqrt2;

/// State of degree 1 under a uniform body force of amplitude f: u, v, s, tau, f r^2, and the integral of
/// (u + sqrt(2) v) r^2 dr divided by r^3. The last one yields the mean amplitude of the uniform displacement
/// (1, sqrt(2)).
using State = Eigen::Matrix<cplx, 6, 1>;

/// Matrix B of the equations z' = B z of this state, with the derivative with respect to ln r.
Eigen::Matrix<cplx, 6, 6> body_force_matrix(const Medium<cplx>& medium, double stress_unit) {
  const cplx mu = medium.mu / stress_unit;
  const cplx b = medium.b;
  const cplx a = 1.0 - 2.0 * b;
  const cplx gamma = mu * (3.0 - 4.0 * b);
  // t = sqrt(2) v - 2 u; L - 2 = 0.
  Eigen::Matrix<cplx, 6, 6> matrix;
  matrix << -2.0 * a, sqrt2 * a, b / mu, 0.0, 0.0, 0.0,                    //
      -sqrt2, 1.0, 0.0, 1.0 / mu, 0.0, 0.0,                                //
      4.0 * gamma, -2.0 * sqrt2 * gamma, 1.0 - 4.0 * b, sqrt2, -1.0, 0.0,  //
      -2.0 * sqrt2 * gamma, 2.0 * gamma, -sqrt2 * a, -2.0, -sqrt2, 0.0,    //
      0.0, 0.0, 0.0, 0.0, 2.0, 0.0,                                        //
      1.0, sqrt2, 0.0, 0.0, 0.0, -3.0;
  return matrix;
}

/// Compliance of degree 1 of a hollow or solid ball; see `degree_compliance`.
DegreeCompliance free_degree_one(const LayerStack<cplx>& layers) {
  // Relative radius of the cavity that replaces the center of a solid ball; its effect is of third order.
  constexpr double kCavity = 1e-4;
  constexpr double kStep = 0.5;  // step in ln r, over which the size of solutions changes little
  const double surface = layers.metric.radius;
  const double stress_unit = std::abs(layers.media.back().mu);
  const double inner = std::max(layers.media.front().inner, kCavity * surface) / surface;

  // Two solutions: a displacement of the free inner surface that is not uniform, and the uniform body force. Lengths
  // are relative to the outer radius.
  Eigen::Matrix<cplx, 6, 2> states = Eigen::Matrix<cplx, 6, 2>::Zero();
  states(1, 0) = 1.0;
  states(4, 1) = inner * inner;
  double radius = inner;
  for (const Medium<cplx>& medium : layers.media) {
    const double extent = std::log(medium.outer / surface / radius);
    if (extent <= 0.0) continue;
    const int steps = static_cast<int>(std::ceil(extent / kStep));
    const Eigen::Matrix<cplx, 6, 6> step = (body_force_matrix(medium, stress_unit) * (extent / steps)).exp();
    for (int i = 0; i < steps; ++i) {
      states = step * states;
      states.col(0) /= states.col(0).head<4>().cwiseAbs().maxCoeff();
    }
    radius = medium.outer / surface;
  }

  // The body force -(s + sqrt(2) tau) / volume balances the stresses s and tau at the surface; a common factor 1/3
  // cancels.
  const double volume = 1.0 - inner * inner * inner;
  const auto displacement = [&](double s, double tau) -> Eigen::Vector2cd {
    const double force = -(s + sqrt2 * tau) / volume;
    const State loaded = force * states.col(1);
    const Eigen::Vector2cd rest(s - loaded(2), tau - loaded(3));
    const cplx amount = states.col(0).segment<2>(2).dot(rest) / states.col(0).segment<2>(2).squaredNorm();
    const State state = loaded + amount * states.col(0);
    const cplx uniform = -state(5) / volume;
    return {state(0) + uniform, state(1) + sqrt2 * uniform};
  };
  const double unit = surface / stress_unit;
  const Eigen::Vector2cd by_radial = unit * displacement(1.0, 0.0);
  const Eigen::Vector2cd by_tangential = unit * displacement(0.0, 1.0);
  return {.radial = by_radial(0), .mixed = by_tangential(0), .along = by_tangential(1), .across = 0.0};
}

}  // namespace

DegreeCompliance degree_compliance(const LayerStack<cplx>& layers, int degree) {
  if (degree == 0) {
    // Degree 0 has no tangential harmonic. With `exact` its membrane stiffness would be negative.
    LayerStack<cplx> radial = layers;
    radial.metric.curvature = Curvature::sphere;
    return {.radial = surface_compliance(radial, 0.0, 0.0)(0, 0), .mixed = 0.0, .along = 0.0, .across = 0.0};
  }
  if (degree == 1 && !inner_surface(layers.inner_boundary).is_core) return free_degree_one(layers);
  if (degree == 1) {
    // m = n = 1 gives k^2 = 2 without round-off. On a small core, any stiffness against rotation has a large effect.
    const Matrix3<cplx> y = surface_compliance(layers, 1.0, 1.0);
    return {.radial = y(0, 0), .mixed = sqrt2 * y(0, 1), .along = y(1, 1) + y(1, 2), .across = y(1, 1) - y(1, 2)};
  }
  const Matrix3<cplx> y = surface_compliance(layers, 0.0, std::sqrt(degree * (degree + 1.0)));
  return {.radial = y(0, 0), .mixed = y(0, 2), .along = y(2, 2), .across = y(1, 1)};
}

std::vector<DegreeCompliance> degree_compliances(const HarmonicBody& body, const Spectrum& spectrum, std::size_t i,
                                                 int highest) {
  constexpr int kFirstOfSpectrum = 2;
  const double order = body.orders()[i];
  const int first = static_cast<int>(std::lround(order));
  std::vector<DegreeCompliance> compliances;
  LayerStack<cplx> layers = body.layers_at(i);
  layers.metric.curvature = Curvature::exact;
  for (int degree = first; degree < std::min(kFirstOfSpectrum, highest + 1); ++degree) {
    compliances.push_back(degree_compliance(layers, degree));
  }
  const int from = std::max(first, kFirstOfSpectrum);
  if (highest < from) return compliances;

  OrderSeries series;
  spectrum.series(i, series);
  const Eigen::ArrayXd degrees = Eigen::ArrayXd::LinSpaced(highest - from + 1, from, highest);
  const Eigen::ArrayXd k = (degrees * (degrees + 1.0)).sqrt();
  // Entries at k^2 = L, with m = 0 and n = k; rtheta and phitheta contain the factor n.
  const OrderValues values(0.0, k, series);
  Eigen::ArrayXcd radial, mixed, phi, phi_theta, theta;
  values.evaluate(Entry::rr, radial);
  values.evaluate(Entry::rtheta, mixed);
  values.evaluate(Entry::phiphi, phi);
  values.evaluate(Entry::phitheta, phi_theta);
  values.evaluate(Entry::thetatheta, theta);
  for (Eigen::Index l = 0; l < k.size(); ++l) {
    // phiphi = across + m^2/k^2 (along - across), thetatheta = along - m^2/k^2 (along - across), phitheta = m n/k^2
    // (along - across).
    const cplx turned = order / k[l] * phi_theta[l];
    compliances.push_back({.radial = radial[l],
                           .mixed = cplx(0.0, 1.0) * mixed[l],
                           .along = theta[l] + turned,
                           .across = phi[l] - turned});
  }
  return compliances;
}

}  // namespace viscoroll::detail
