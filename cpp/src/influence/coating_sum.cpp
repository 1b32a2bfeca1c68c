#include "influence/coating_sum.hpp"

#include <algorithm>
#include <utility>

namespace viscoroll::detail {
namespace {

double highest(const std::vector<OrderBand>& bands) {
  double highest = 0.0;
  for (const OrderBand& band : bands) highest = std::max(highest, band.orders[band.orders.size() - 1]);
  return highest;
}

std::vector<double> scaled(std::vector<double> orders, double factor) {
  for (double& order : orders) order *= factor;
  return orders;
}

/// Check the body before bands are made from it: arguments in braces are evaluated in order.
LayeredBody checked(LayeredBody body, double angular_speed) {
  require_layers_and_speed(body, angular_speed);
  return body;
}

OrderSum order_sum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh,
                   std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                   Watch& watch, const LocalMetric& metric, double inertia_tolerance) {
  // If the wave number is m / sine, the speed Omega sine gives the frequency m Omega.
  const HarmonicBody harmonics(body, angular_speed * metric.sine, scaled(all_orders(phi_bands), 1.0 / metric.sine),
                               measured_order(mesh.rounded()) / metric.sine);
  auto spectrum = make_spectrum(harmonics, highest(theta_bands), threads, watch, inertia_tolerance);
  return {mesh, harmonics.radius(), std::move(phi_bands), theta_bands, std::move(spectrum), metric};
}

}  // namespace

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, int threads, Watch& watch,
                       double inertia_tolerance)
    : CoatingSum{checked(body, angular_speed),
                 angular_speed,
                 mesh,
                 phi_bands(body, angular_speed, mesh.rounded()),
                 theta_bands(body, angular_speed, mesh.rounded(), 0.0, mesh.widest()),
                 threads,
                 watch,
                 {},
                 inertia_tolerance} {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh,
                       std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                       Watch& watch, const LocalMetric& metric, double inertia_tolerance)
    : sum_(order_sum(body, angular_speed, mesh, std::move(phi_bands), theta_bands, threads, watch, metric,
                     inertia_tolerance)) {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, const LocalMetric& metric,
                       int threads, Watch& watch)
    : CoatingSum{checked(body, angular_speed),
                 angular_speed,
                 mesh,
                 phi_bands(body, angular_speed, mesh.rounded(), metric.exact_degree),
                 theta_bands(body, angular_speed, mesh.rounded(), metric.exact_degree),
                 threads,
                 watch,
                 metric} {}

}  // namespace viscoroll::detail
