#include "influence/coating_sum.hpp"

#include <algorithm>
#include <string>

#include "validate.hpp"

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

/// Bands are made of what has been checked alone.
CoatedSphere checked(CoatedSphere sphere, double angular_speed) {
  validate(sphere);
  if (sphere.layers.empty()) reject("layers", "a list of at least one layer", "none");
  require_positive("angular_speed", angular_speed, "rad/s");
  return sphere;
}

}  // namespace

CoatingSum::CoatingSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int threads, Watch& watch,
                       Curvature curvature, double inertia_tolerance)
    : CoatingSum(checked(sphere, angular_speed), angular_speed, mesh, phi_bands(sphere, angular_speed, mesh),
                 theta_bands(sphere, angular_speed, mesh), threads, watch, curvature, {}, inertia_tolerance) {}

CoatingSum::CoatingSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh,
                       std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                       Watch& watch, Curvature curvature, const LocalMetric& metric, double inertia_tolerance)
    :  // Where the wave number is m / sine, the speed Omega sine sees the frequency m Omega.
      coating_(sphere, angular_speed * metric.sine, scaled(all_orders(phi_bands), 1.0 / metric.sine),
               measured_order(mesh) / metric.sine, curvature),
      sum_(mesh, coating_.outer_radius(), std::move(phi_bands), theta_bands,
           make_spectrum(coating_, highest(theta_bands), threads, watch, inertia_tolerance), metric) {}

CoatingSum::CoatingSum(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, const LocalMetric& metric,
                       int threads, Watch& watch)
    : CoatingSum(checked(sphere, angular_speed), angular_speed, mesh,
                 phi_bands(sphere, angular_speed, mesh, metric.exact_degree),
                 theta_bands(sphere, angular_speed, mesh, metric.exact_degree), threads, watch, Curvature::sphere,
                 metric) {}

OrderSum plane_sum(const CoatedPlane& plane, double angular_speed, double radius, const Mesh& mesh, int threads,
                   Watch& watch) {
  validate(plane);
  require_positive("angular_speed", angular_speed, "rad/s");
  require_positive("radius", radius, "m");
  if (mesh.max_order) {
    reject("mesh.max_order", "left out where a plane deforms, whose orders are not whole",
           std::to_string(*mesh.max_order));
  }
  PlaneBands bands = plane_bands(plane, angular_speed, radius, mesh);
  const HarmonicPlane harmonics(plane, angular_speed * radius, radius, all_orders(bands.phi), measured_order(mesh));
  auto spectrum = make_spectrum(harmonics, highest(bands.theta), threads, watch);
  return {mesh, radius, std::move(bands.phi), std::move(bands.theta), std::move(spectrum)};
}

}  // namespace viscoroll::detail
