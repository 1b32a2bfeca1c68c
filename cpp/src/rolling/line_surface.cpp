#include "rolling/line_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "influence/line_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/table_store.hpp"

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

BodySurface surface_under_line(const LayeredBody& layers, const Crossing& crossing) {
  const auto& [threads, watch] = crossing.execution;
  const Mesh& mesh = crossing.mesh;
  const double radius = layers.metric.radius;
  const double angular_speed = crossing.speed() / radius;
  const double arc = crossing.arc();
  const Mesh around = mesh_around(2.0 * std::numbers::pi * radius, arc, mesh);
  const double limit = measured_order(around);
  std::vector<OrderBand> bands = phi_bands(layers, angular_speed, around);
  const HarmonicBody harmonics(layers, angular_speed, all_orders(bands), limit);
  const HarmonicBody alternating(layers, angular_speed, {std::numbers::pi * radius / arc}, limit);
  const Eigen::Matrix3cd compliance = alternating.compliance({.i = 0, .n = 0.0});
  BodySurface surface{.tables = nullptr,
                      .normal = compliance(0, 0),
                      .along = compliance(1, 1),
                      .stiffest_modulus = harmonics.stiffest_modulus(),
                      .centrifugal = centrifugal_displacement(layers, angular_speed)};
  surface.tables =
      std::make_unique<const TableStore>(std::make_unique<const LineSum>(std::move(bands), harmonics, arc / radius,
                                                                         arc / phi_spacing(mesh), threads, watch),
                                         mesh);
  return surface;
}

}  // namespace viscoroll::detail
