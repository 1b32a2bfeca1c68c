#include "rolling/line_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "influence/line_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {
namespace {

/// Nodes per revolution of another circumference, for the choice of bands.
Mesh mesh_around(double circumference, double arc, const Mesh& mesh) {
  Mesh other = mesh;
  constexpr double kLargestInt = std::numeric_limits<int>::max();
  other.nodes_per_revolution = static_cast<int>(std::clamp(std::round(circumference / arc), 16.0, kLargestInt));
  return other;
}

}  // namespace

LineSurface line_surface(const LayeredBody& body, double surface_speed, double arc, const Mesh& mesh, int threads,
                         Watch& watch) {
  LineSurface surface;
  if (body.layers.empty()) return surface;
  const double radius = body.metric.radius;
  const double angular_speed = surface_speed / radius;
  const Mesh around = mesh_around(2.0 * std::numbers::pi * radius, arc, mesh);
  const double limit = measured_order(around);
  std::vector<OrderBand> bands = phi_bands(body, angular_speed, around);
  const HarmonicBody harmonics(body, angular_speed, all_orders(bands), limit);
  const HarmonicBody alternating(body, angular_speed, {std::numbers::pi * radius / arc}, limit);
  const Eigen::Matrix3cd compliance = alternating.compliance({.i = 0, .n = 0.0});
  surface.normal = compliance(0, 0);
  surface.along = compliance(1, 1);
  surface.stiffest_modulus = harmonics.stiffest_modulus();
  surface.centrifugal = centrifugal_displacement(body, angular_speed);
  surface.sum = std::make_unique<const LineSum>(std::move(bands), harmonics, arc / radius, arc / phi_spacing(mesh),
                                                threads, watch);
  return surface;
}

}  // namespace viscoroll::detail
