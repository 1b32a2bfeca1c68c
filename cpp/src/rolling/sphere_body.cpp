// A ball, touching in a spot: translation-invariant tables of the orders (m, n), or those of the exact sphere.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "influence/coating_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "rolling/body.hpp"
#include "rolling/sphere_tables.hpp"
#include "rolling/table_store.hpp"
#include "validate.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll::detail {
namespace {

/// Inertia joins neighboring degrees on the exact sphere: it is left out there, or the speed refused where it counts.
CoatedSphere without_inertia(CoatedSphere sphere, double angular_speed) {
  constexpr double kNegligible = 1e-3;  // of rho (Omega r_o)^2 per modulus, which changes the torque by less
  const HarmonicCoating coating = coating_at_rest(sphere, angular_speed, Curvature::sphere);
  const double speed = angular_speed * coating.outer_radius();
  for (std::size_t l = 0; l < sphere.layers.size(); ++l) {
    const double share = sphere.layers[l].density * speed * speed / std::abs(coating.modulus(l, 0));
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

/// Largest modulus of a layer at the highest order.
double stiffest_modulus(const CoatedSphere& sphere, const Crossing& crossing, Curvature curvature) {
  const double speed = crossing.angular_speed;
  const HarmonicCoating coating(sphere, speed, all_orders(phi_bands(sphere, speed, crossing.mesh)),
                                measured_order(crossing.mesh), curvature);
  const auto highest = std::ranges::max_element(coating.orders()) - coating.orders().begin();
  double stiffest = 0.0;
  for (std::size_t layer = 0; layer < sphere.layers.size(); ++layer) {
    stiffest = std::max(stiffest, std::abs(coating.modulus(layer, static_cast<std::size_t>(highest))));
  }
  return stiffest;
}

BodySurface surface_of(const CoatedSphere& sphere, const Crossing& crossing) {
  BodySurface surface;
  if (sphere.layers.empty()) return surface;
  const auto& [threads, watch] = crossing.execution;
  const double speed = crossing.angular_speed;
  const Mesh& mesh = crossing.mesh;
  const bool exact = crossing.curvature == Curvature::exact;
  const Curvature curvature = exact ? Curvature::sphere : crossing.curvature;
  const CoatedSphere rolling = exact ? without_inertia(sphere, speed) : sphere;
  surface.stiffest_modulus = stiffest_modulus(rolling, crossing, curvature);
  if (exact) {
    surface.tables = std::make_unique<const SphereTables>(SphereSum(rolling, speed, mesh), mesh);
  } else {
    surface.tables = std::make_unique<const TableStore>(
        std::make_unique<const CoatingSum>(rolling, speed, mesh, threads, watch, curvature, crossing.inertia_tolerance),
        mesh);
  }
  surface.centrifugal = centrifugal_displacement(coating_at_rest(sphere, speed, curvature));
  const std::array m{mesh.nodes_per_revolution / 2};
  const std::array n{0};
  const ComplexMatrix3 alternating = surface_compliance(rolling, speed, m, n, curvature).front();
  surface.normal = alternating[0];
  surface.along = alternating[4];
  return surface;
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
  const Curvatures curvatures{.along = 1.0 / radius, .across = 1.0 / radius};
  return {.type = "CoatedSphere",
          .layers = named(sphere.layers),
          .curvatures = curvatures,
          .surface = [sphere](const Crossing& crossing) { return surface_of(sphere, crossing); },
          .profile = circles(curvatures),
          .name = "sphere",
          .counterparts = {"CoatedPlane", "Groove"},
          .radius = radius,
          .form = kSpotContact,
          .nodes = [radius](const Mesh& mesh, bool soft) { return nodes_of(radius, mesh, soft); }};
}

}  // namespace viscoroll::detail
