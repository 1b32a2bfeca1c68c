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

/// Bands are made of what has been checked alone: arguments in braces are evaluated one after another.
LayeredBody checked(LayeredBody body, double angular_speed) {
  require_rolling(body, angular_speed);
  return body;
}

OrderSum order_sum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const Patches& patches,
                   std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                   Watch& watch, const LocalMetric& metric, double inertia_tolerance) {
  // Where the wave number is m / sine, the speed Omega sine sees the frequency m Omega.
  const HarmonicBody harmonics(body, angular_speed * metric.sine, scaled(all_orders(phi_bands), 1.0 / metric.sine),
                               measured_order(mesh) / metric.sine);
  auto spectrum = make_spectrum(harmonics, highest(theta_bands), threads, watch, inertia_tolerance);
  return {patches, harmonics.radius(), std::move(phi_bands), theta_bands, std::move(spectrum), metric};
}

}  // namespace

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const Patches& patches,
                       std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                       Watch& watch, const LocalMetric& metric, double inertia_tolerance)
    : mesh_(mesh),
      sum_(order_sum(body, angular_speed, mesh, patches, std::move(phi_bands), theta_bands, threads, watch, metric,
                     inertia_tolerance)) {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const Patches& patches,
                       int threads, Watch& watch, double inertia_tolerance)
    : CoatingSum{checked(body, angular_speed),
                 angular_speed,
                 mesh,
                 patches,
                 phi_bands(body, angular_speed, mesh),
                 theta_bands(body, angular_speed, mesh, 0.0, patches.widest),
                 threads,
                 watch,
                 {},
                 inertia_tolerance} {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, int threads, Watch& watch,
                       double inertia_tolerance)
    : CoatingSum(body, angular_speed, mesh, patches_of(mesh), threads, watch, inertia_tolerance) {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh,
                       std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                       Watch& watch)
    : CoatingSum(body, angular_speed, mesh, patches_of(mesh), std::move(phi_bands), theta_bands, threads, watch, {},
                 kInertiaTolerance) {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const Mesh& mesh, const LocalMetric& metric,
                       int threads, Watch& watch)
    : CoatingSum{checked(body, angular_speed),
                 angular_speed,
                 mesh,
                 patches_of(mesh),
                 phi_bands(body, angular_speed, mesh, metric.exact_degree),
                 theta_bands(body, angular_speed, mesh, metric.exact_degree),
                 threads,
                 watch,
                 metric,
                 kInertiaTolerance} {}

}  // namespace viscoroll::detail
