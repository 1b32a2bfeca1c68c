#include "rolling/mesh_model.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "influence/coating_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
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

/// Loads that alternate from row to row see the mesh's highest order m. The displacement at the nodes resists them with
/// the real part of its compliance alone, |C| cos(a), which dies out as the phase a comes close to 90 degrees, as that
/// of a Kelvin-Voigt material does. Displacements that are taken s spacings downstream resist with |C| cos(a - pi s):
/// at 45 degrees and less s = 0, beyond so much that a - pi s stays there. Theory.md section 5.
/// @param[in] normal,along compliance of that order
double stable_collocation(std::complex<double> normal, std::complex<double> along) {
  const double phase = std::max(-std::arg(normal), -std::arg(along));
  return std::clamp(phase / std::numbers::pi - 0.25, 0.0, 0.25);
}

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

}  // namespace

MeshModel::MeshModel(const RollingPair& pair, double angular_speed, const Mesh& mesh, Curvature curvature, int threads,
                     Watch& watch, double inertia_tolerance)
    : pair_(pair), angular_speed_(angular_speed), mesh_(mesh), curvature_(curvature) {
  if (const auto* sphere = std::get_if<CoatedSphere>(&pair.body)) {
    if (!is_rigid(pair.body)) roll_sphere(*sphere, threads, watch, inertia_tolerance);
    if (!is_rigid(pair.on)) roll_over(plane_of(pair.on), threads, watch);
  } else {
    roll_cylinder(std::get<CoatedCylinder>(pair.body), threads, watch);
  }
  collocation_ = stable_collocation(alternating_.normal, alternating_.along);
}

void MeshModel::roll_over(const CoatedPlane& plane, int threads, Watch& watch) {
  if (curvature_ == Curvature::exact) {
    reject("curvature", "SPHERE or PAPER where what the ball rolls on deforms", "EXACT");
  }
  const double radius = outer_radius(body());
  const LayeredBody layers = layered_body(plane, radius);
  track_ = std::make_unique<const TableStore>(
      std::make_unique<const CoatingSum>(layers, angular_speed_, mesh_, threads, watch), mesh_);
  const double highest = 0.5 * mesh_.nodes_per_revolution;
  count_in(HarmonicBody(layers, angular_speed_, {highest, 16.0 * highest}, measured_order(mesh_)));
}

void MeshModel::roll_sphere(const CoatedSphere& sphere, int threads, Watch& watch, double inertia_tolerance) {
  const bool exact = curvature_ == Curvature::exact;
  const CoatedSphere rolling = exact ? without_inertia(sphere, angular_speed_) : sphere;
  const LayeredBody layers = layered_body(rolling, exact ? Curvature::sphere : curvature_);
  const HarmonicBody harmonics(layers, angular_speed_, all_orders(phi_bands(layers, angular_speed_, mesh_)),
                               measured_order(mesh_));
  if (exact) {
    sphere_tables_ = std::make_unique<const SphereTables>(SphereSum(layers, angular_speed_, mesh_));
  } else {
    own_ = std::make_unique<const TableStore>(
        std::make_unique<const CoatingSum>(layers, angular_speed_, mesh_, threads, watch, inertia_tolerance), mesh_);
  }
  pair_.body = rolling;
  centrifugal_ = centrifugal_displacement(layered_body(sphere, layers.metric.curvature), angular_speed_);
  count_in(HarmonicBody(layers, angular_speed_, {1.0 * (mesh_.nodes_per_revolution / 2)}));
  stiffest_modulus_ = harmonics.stiffest_modulus();
}

void MeshModel::roll_cylinder(const CoatedCylinder& cylinder, int threads, Watch& watch) {
  require_line_mesh(mesh_);
  require_curvature_of_cylinder(curvature_);
  const double radius = viscoroll::outer_radius(cylinder);
  const double speed = angular_speed_ * radius;
  const double arc = radius * phi_spacing(mesh_);
  own_ = count_in(line_surface(layered_body(cylinder), speed, arc, mesh_, threads, watch));
  const auto* plane = std::get_if<CoatedPlane>(&pair_.on);
  const LayeredBody on =
      plane != nullptr ? layered_body(*plane, radius) : layered_body(std::get<CoatedCylinder>(pair_.on));
  track_ = count_in(line_surface(on, speed, arc, mesh_, threads, watch));
}

void MeshModel::count_in(const HarmonicBody& body) {
  const Eigen::Matrix3cd compliance = body.compliance({.i = 0, .n = 0.0});
  alternating_.normal += compliance(0, 0);
  alternating_.along += compliance(1, 1);
  stiffest_modulus_ = std::max(stiffest_modulus_, body.stiffest_modulus());
}

std::unique_ptr<const TableStore> MeshModel::count_in(LineSurface surface) {
  alternating_.normal += surface.normal;
  alternating_.along += surface.along;
  stiffest_modulus_ = std::max(stiffest_modulus_, surface.stiffest_modulus);
  centrifugal_ += surface.centrifugal;
  return surface.sum ? std::make_unique<const TableStore>(std::move(surface.sum), mesh_) : nullptr;
}

SurfaceGrid MeshModel::grid() const {
  const double radius = outer_radius(body());
  // The patch of a roller's node is a meter wide: forces on nodes are forces per length.
  return {.radius = radius,
          .phi_spacing = phi_spacing(mesh_),
          .theta_spacing = is_roller(body()) ? 1.0 / radius : theta_spacing(mesh_),
          .is_paraboloid = track_ && !is_roller(body())};
}

}  // namespace viscoroll::detail
