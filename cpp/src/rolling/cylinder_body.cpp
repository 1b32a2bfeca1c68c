// A roller, or another one that it rolls on, touching along a line: theory.md section 14.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "influence/line_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/cylinder_compliance.hpp"
#include "rolling/body.hpp"
#include "rolling/table_store.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// A row of nodes has no spacing sideways: its nodes bear forces per length.
void require_line_mesh(const Mesh& mesh) {
  if (mesh.theta_nodes_per_revolution) {
    reject("mesh.theta_nodes_per_revolution", "left out with a cylinder, whose contact is a single row of nodes",
           std::to_string(*mesh.theta_nodes_per_revolution));
  }
}

void require_curvature_of_cylinder(Curvature curvature) {
  if (curvature == Curvature::sphere) return;
  reject("curvature", "left out with a cylinder, whose equations keep all of it",
         curvature == Curvature::exact ? "EXACT" : "PAPER");
}

/// Nodes per revolution of another circumference, for the choice of bands.
Mesh mesh_around(double circumference, double arc, const Mesh& mesh) {
  Mesh other = mesh;
  constexpr double kLargestInt = std::numeric_limits<int>::max();
  other.nodes_per_revolution = static_cast<int>(std::clamp(std::round(circumference / arc), 16.0, kLargestInt));
  return other;
}

BodySurface surface_of(const CoatedCylinder& cylinder, const Crossing& crossing) {
  const auto& [threads, watch] = crossing.execution;
  const Mesh& mesh = crossing.mesh;
  require_line_mesh(mesh);
  require_curvature_of_cylinder(crossing.curvature);
  BodySurface surface;
  if (cylinder.layers.empty()) return surface;
  const double radius = outer_radius(cylinder);
  const double angular_speed = crossing.speed() / radius;
  const double arc = crossing.arc();
  const Mesh around = mesh_around(2.0 * std::numbers::pi * radius, arc, mesh);
  std::vector<OrderBand> bands = phi_bands(layers_about_center(cylinder), angular_speed, around);
  const std::vector<double> orders = all_orders(bands);
  const double limit = measured_order(around);
  LineSpectrum spectrum = cylinder_spectrum(cylinder, angular_speed, orders, limit, threads, watch);

  const std::vector<double> few{0.0, std::numbers::pi * radius / arc, *std::ranges::max_element(orders)};
  const LineCompliance<cplx> alternating = cylinder_spectrum(cylinder, angular_speed, few, limit, threads, watch)[1];
  surface.normal = alternating.normal;
  surface.along = alternating.along;
  std::vector<cplx> at_rest;
  for (const auto& moduli : harmonic_moduli(cylinder.layers, angular_speed, few, limit)) {
    at_rest.push_back(moduli.front());
    surface.stiffest_modulus = std::max(surface.stiffest_modulus, std::abs(moduli.back()));
  }
  surface.centrifugal = cylinder_centrifugal_displacement(cylinder_media(cylinder, at_rest, angular_speed));
  surface.tables =
      std::make_unique<const TableStore>(std::make_unique<const LineSum>(std::move(bands), std::move(spectrum), radius,
                                                                         arc / radius, arc / phi_spacing(mesh)),
                                         mesh);
  return surface;
}

/// At the same arcs as the nodes of what rolls on it.
Profile profile_of(double radius, const SurfaceWindow& points) {
  const Eigen::ArrayXd forward = (std::numbers::pi / 2.0 - points.phi()) * (points.grid().radius / radius);
  return {.drop = 2.0 * radius * (0.5 * forward).sin().square(), .slope = forward.sin()};
}

/// The patch of a node is a meter wide: forces on nodes are forces per length.
Nodes nodes_of(double radius, const Mesh& mesh) {
  const int phi = nodes_to_60_degrees(mesh.nodes_per_revolution);
  return {.grid = {.radius = radius, .phi_spacing = phi_spacing(mesh), .theta_spacing = 1.0 / radius},
          .widest = {{-phi, phi}, {0, 0}}};
}

void require_flat_patches(const Options& options) {
  if (options.patch_load != PatchLoad::flat) reject("patch_load", "FLAT with a cylinder", "SPHERICAL");
}

}  // namespace

Body make_body(const CoatedCylinder& cylinder) {
  const double radius = outer_radius(cylinder);
  return {.type = "CoatedCylinder",
          .layers = named(cylinder.layers),
          .curvatures = {.along = 1.0 / radius},
          .surface = [cylinder](const Crossing& crossing) { return surface_of(cylinder, crossing); },
          .profile = [radius](const SurfaceWindow& points) { return profile_of(radius, points); },
          .name = "roller",
          .counterparts = {"CoatedPlane", "CoatedCylinder"},
          .radius = radius,
          .form = kLineContact,
          .nodes = [radius](const Mesh& mesh, bool) { return nodes_of(radius, mesh); },
          .require = require_flat_patches};
}

}  // namespace viscoroll::detail
