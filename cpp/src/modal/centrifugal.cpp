// Order m = n = 0 under the centrifugal load, the term -rho Omega^2 r of equation (27) of the paper. Its unknowns are
// u_r and sigma_rr.
#include "modal/centrifugal.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <vector>

#include "modal/harmonic_body.hpp"
#include "modal/layer_stack.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll {
namespace detail {
namespace {

using RadialState = Eigen::Vector2d;  // u_r [m], r sigma_rr [stress unit x m]

constexpr int kMaxSeriesTerms = 60;

/// Solve (1 + x) dz/dx = (B + q (1 + x)^2 M) z - q r (1 + x)^3 e, z(0) = start, over one radial step by a Taylor
/// series. Since M = -e (1, 0) and e = (0, 1), load and inertia enter as -q (1 + x)^2 (u_r + r (1 + x)).
RadialState advance(const Eigen::Matrix2d& elastic, double q, double load_radius, const RadialState& start, double x) {
  RadialState sum = start;
  RadialState term = start;
  // Terms of the series of u_r + r (1 + x); the rigid part contributes r and r x.
  std::array<double, 3> recent{start(0) + load_radius, 0.0, 0.0};
  for (int j = 0; j < kMaxSeriesTerms; ++j) {
    RadialState next = elastic * term - j * term;
    next(1) -= q * (recent[0] + 2.0 * x * recent[1] + x * x * recent[2]);
    next *= x / (j + 1);
    sum += next;
    recent = {next(0) + (j == 0 ? load_radius * x : 0.0), recent[0], recent[1]};
    term = next;
  }
  return sum;
}

/// Matrix of the equations of u_r and r sigma_rr without inertia, those of layer_step.hpp at k = 0.
Eigen::Matrix2d elastic_matrix(const Metric& metric, double mu, double b) {
  const double curved_axes = metric.curved_axes();
  const double gamma = (metric.is_sphere() ? 3.0 : 4.0) - 4.0 * b;
  return Eigen::Matrix2d{{-curved_axes * (1.0 - 2.0 * b), b / mu},
                         {curved_axes * curved_axes * mu * gamma, 1.0 - 2.0 * curved_axes * b}};
}

}  // namespace

std::vector<Eigen::Vector2d> centrifugal_states(const LayerStack<std::complex<double>>& layers) {
  const auto& media = layers.media;
  const bool is_free = inner_surface(layers.inner_boundary).is_free;
  const double stress_unit = media.back().mu.real();

  // The recursion carries u_r = compliance * (r sigma_rr) + offset outwards from the rigid core to the free surface.
  double compliance = 0.0;
  double offset = 0.0;
  struct Step {
    double stress;  // at the outer end, per unit of the starting value
    double load;    // at the outer end, due to the load within the step
    double compliance;
    double offset;
    bool ends_layer;
  };
  std::vector<Step> taken;
  for (const auto& medium : media) {
    const double mu = medium.mu.real() / stress_unit;
    const double b = medium.b.real();
    const Eigen::Matrix2d elastic = elastic_matrix(layers.metric, mu, b);
    // In a solid ball the solution that is not regular at the center decays like r^-3 relative to the regular one. From
    // this depth it is negligible at the surface.
    const double inner = std::max(medium.inner, 1e-6 * medium.outer);
    const double extent = std::log(medium.outer / inner);
    bool free = is_free && taken.empty();
    const int steps = static_cast<int>(std::ceil(extent / 0.2));
    const double x = std::expm1(extent / steps);
    for (int step = 0; step < steps; ++step) {
      const double radius = inner * std::exp(extent * step / steps);
      const double q = medium.inertia * radius * radius / stress_unit;
      const RadialState start = free ? RadialState{1.0, 0.0} : RadialState{compliance, 1.0};
      const RadialState unit_stress = advance(elastic, q, 0.0, start, x);
      const RadialState loaded = advance(elastic, q, radius, {offset, 0.0}, x);
      compliance = unit_stress(0) / unit_stress(1);
      offset = loaded(0) - compliance * loaded(1);
      free = false;
      taken.push_back({.stress = unit_stress(1),
                       .load = loaded(1),
                       .compliance = compliance,
                       .offset = offset,
                       .ends_layer = step == steps - 1});
    }
  }

  std::vector<RadialState> states;
  double stress = 0.0;
  for (const auto& step : std::views::reverse(taken)) {
    if (step.ends_layer) states.emplace_back(step.compliance * stress + step.offset, stress * stress_unit);
    stress = (stress - step.load) / step.stress;
  }
  states.emplace_back(is_free ? RadialState{stress, 0.0} : RadialState{0.0, stress * stress_unit});
  std::ranges::reverse(states);
  return states;
}

double centrifugal_displacement(const LayeredBody& body, double angular_speed) {
  if (!body.metric.is_curved()) return 0.0;
  return centrifugal_states(body_at_order_zero(body, angular_speed).layers_at(0)).back()(0);
}

}  // namespace detail

double centrifugal_displacement(const CoatedSphere& sphere, double angular_speed) {
  // The choice of the curvature terms affects tangential displacements only, and the uniform displacement has none.
  return detail::centrifugal_displacement(detail::checked_layered_body(sphere), angular_speed);
}

}  // namespace viscoroll
