// A ball, or another one that it rolls on, touching in a spot: translation-invariant tables of the orders (m, n), or
// those of the exact sphere.
#include <cmath>
#include <string>
#include <utility>

#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/body.hpp"
#include "rolling/sphere_tables.hpp"
#include "rolling/spot_surface.hpp"
#include "rolling/table_store.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// Inertia joins neighboring degrees on the exact sphere: it is left out there, or the speed refused where it counts.
CoatedSphere without_inertia(CoatedSphere sphere, double angular_speed) {
  constexpr double kNegligible = 1e-3;  // of rho (Omega r_o)^2 per modulus, which changes the torque by less
  const HarmonicBody body = body_at_rest(layered_body(sphere), angular_speed);
  const double speed = angular_speed * body.radius();
  for (std::size_t l = 0; l < sphere.layers.size(); ++l) {
    const double share = sphere.layers[l].density * speed * speed / std::abs(body.modulus(l, 0));
    if (share > kNegligible) {
      reject("layers[" + std::to_string(l) + "].density",
             "so small that inertia is negligible with curvature EXACT, at most " +
                 text(sphere.layers[l].density * kNegligible / share) + " kg/m^3 at this speed",
             text(sphere.layers[l].density) + " kg/m^3");
    }
    sphere.layers[l].density = 0.0;
  }
  return sphere;
}

BodySurface surface_of(const CoatedSphere& sphere, const Crossing& crossing) {
  BodySurface surface;
  if (sphere.layers.empty()) return surface;
  const double radius = outer_radius(sphere);
  const double speed = crossing.angular_speed_at(radius);
  const MeshOnBody mesh = crossing.mesh_at(radius);
  const Mesh& around = mesh.rounded();
  const bool exact = crossing.curvature == Curvature::exact;
  const LayeredBody layers =
      layered_body(exact ? without_inertia(sphere, speed) : sphere, exact ? Curvature::sphere : crossing.curvature);
  const HarmonicBody harmonics(layers, speed, all_orders(phi_bands(layers, speed, around)), measured_order(around));
  surface.stiffest_modulus = harmonics.stiffest_modulus();
  if (exact) {
    surface.tables = std::make_unique<const SphereTables>(SphereSum(layers, speed, mesh), around);
  } else {
    surface.tables = std::make_unique<const TableStore>(sum_under_spot(layers, crossing), around);
  }
  surface.centrifugal = centrifugal_displacement(layered_body(sphere, layers.metric.curvature), speed);
  const int highest_order = around.nodes_per_revolution / 2;
  const HarmonicBody alternating(layers, speed, {static_cast<double>(highest_order)});
  const Eigen::Matrix3cd compliance = alternating.compliance({.i = 0, .n = 0.0});
  surface.normal = compliance(0, 0);
  surface.along = compliance(1, 1);
  return surface;
}

/// The height of what rolls on it, so many times: the gap's slope along the nodes is x over the relative radius.
Profile profile_of(double radius, const SurfaceWindow& points) {
  return {.drop = points.grid().radius / radius * points.height(), .slope = points.x() / radius};
}

Nodes nodes_of(double radius, const Mesh& mesh, bool counterpart_deforms) {
  const int phi = nodes_to_60_degrees(mesh.nodes_per_revolution);
  const int theta = nodes_to_60_degrees(theta_nodes_per_revolution(mesh));
  return {.grid = {.radius = radius,
                   .phi_spacing = phi_spacing(mesh),
                   .theta_spacing = theta_spacing(mesh),
                   .is_paraboloid = counterpart_deforms},
          .widest = {{-phi, phi}, {-theta, theta}}};
}

}  // namespace

Body make_body(const CoatedSphere& sphere) {
  const double radius = outer_radius(sphere);
  return {.type = "CoatedSphere",
          .layers = named(sphere.layers),
          .curvatures = {.along = 1.0 / radius, .across = 1.0 / radius},
          .surface = [sphere](const Crossing& crossing) { return surface_of(sphere, crossing); },
          .layered = [sphere](const Crossing& crossing) { return layered_body(sphere, crossing.curvature); },
          .profile = [radius](const SurfaceWindow& points) { return profile_of(radius, points); },
          .name = "sphere",
          .counterparts = {"CoatedPlane", "Groove", "CoatedSphere"},
          .radius = radius,
          .form = kSpotContact,
          .nodes = [radius](const Mesh& mesh, const Body& on) { return nodes_of(radius, mesh, !on.is_rigid()); }};
}

}  // namespace viscoroll::detail
