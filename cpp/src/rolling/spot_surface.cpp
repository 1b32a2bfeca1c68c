#include "rolling/spot_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "influence/coating_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/table_store.hpp"

namespace viscoroll::detail {
namespace {

/// The nearest mesh of whole parts of a revolution, for the choice of orders.
Mesh nearest_mesh(const Patches& patches, const Mesh& mesh) {
  const auto nodes = [](double spacing) {
    constexpr double kLargestInt = std::numeric_limits<int>::max();
    return static_cast<int>(std::clamp(std::round(2.0 * std::numbers::pi / spacing), 16.0, kLargestInt));
  };
  return {.nodes_per_revolution = nodes(patches.phi),
          .max_order = mesh.max_order,
          .theta_nodes_per_revolution = nodes(patches.theta)};
}

}  // namespace

BodySurface surface_under_spot(const LayeredBody& layers, const Crossing& crossing) {
  const auto& [threads, watch] = crossing.execution;
  const double turns = crossing.radius / layers.metric.radius;
  const Patches patches{.phi = turns * phi_spacing(crossing.mesh),
                        .theta = turns * crossing.theta_spacing,
                        .widest = turns * crossing.widest,
                        .turns = turns};
  const Mesh mesh = nearest_mesh(patches, crossing.mesh);
  const double angular_speed = turns * crossing.angular_speed;
  BodySurface surface;
  surface.tables =
      std::make_unique<const TableStore>(std::make_unique<const CoatingSum>(layers, angular_speed, mesh, patches,
                                                                            threads, watch, crossing.inertia_tolerance),
                                         crossing.mesh);
  const double highest = std::numbers::pi / patches.phi;
  const HarmonicBody harmonics(layers, angular_speed, {highest, 16.0 * highest}, measured_order(mesh));
  const Eigen::Matrix3cd compliance = harmonics.compliance({.i = 0, .n = 0.0});
  surface.normal = compliance(0, 0);
  surface.along = compliance(1, 1);
  surface.stiffest_modulus = harmonics.stiffest_modulus();
  surface.centrifugal = centrifugal_displacement(layers, angular_speed);
  return surface;
}

}  // namespace viscoroll::detail
