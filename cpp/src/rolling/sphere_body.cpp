// Ball, as the rolling body or the counterbody, in point contact: translation-invariant tables of the orders (m, n), or
// those of the exact sphere.
#include <cmath>
#include <memory>
#include <string>

#include "base/validate.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/body.hpp"
#include "rolling/point_contact_surface.hpp"
#include "rolling/sphere_tables.hpp"

namespace viscoroll::detail {
namespace {

/// Inertia couples neighboring degrees of the exact sphere. It is left out if it is negligible; otherwise the speed is
/// rejected.
CoatedSphere without_inertia(CoatedSphere sphere, double angular_speed) {
  constexpr double kNegligible = 1e-3;  // of rho (Omega r_o)^2 / |modulus|; the torque changes by less
  const HarmonicBody body = body_at_order_zero(layered_body(sphere), angular_speed);
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

/// Surface of the exact sphere, with inertia in the centrifugal displacement only.
BodySurface surface_of_exact_sphere(const CoatedSphere& sphere, const ContactKinematics& kinematics) {
  const double radius = outer_radius(sphere);
  const double speed = kinematics.angular_speed_at(radius);
  const MeshOnBody mesh = kinematics.mesh_at(radius);
  const LayeredBody layers = layered_body(without_inertia(sphere, speed));
  BodySurface surface = surface_under_spot(
      layers, kinematics, std::make_unique<const SphereTables>(SphereSum(layers, speed, mesh), mesh.rounded()));
  surface.centrifugal = centrifugal_displacement(layered_body(sphere, layers.metric.curvature), speed);
  return surface;
}

BodySurface surface_of(const CoatedSphere& sphere, const ContactKinematics& kinematics) {
  if (sphere.layers.empty()) return {};
  if (kinematics.curvature == Curvature::exact) return surface_of_exact_sphere(sphere, kinematics);
  return surface_under_spot(layered_body(sphere, kinematics.curvature), kinematics);
}

/// Height of the rolling body's nodes times the ratio of the radii: the slope of the gap along the nodes is then x
/// divided by the relative radius.
Profile profile_of(double radius, const SurfaceWindow& points) {
  return {.drop = points.grid().radius / radius * points.height(), .slope = points.x() / radius};
}

Nodes nodes_of(double radius, const Mesh& mesh, bool counterbody_deforms) {
  const int phi = nodes_to_60_degrees(mesh.nodes_per_revolution);
  const int theta = nodes_to_60_degrees(theta_nodes_per_revolution(mesh));
  return {.grid = {.radius = radius,
                   .phi_spacing = phi_spacing(mesh),
                   .theta_spacing = theta_spacing(mesh),
                   .is_paraboloid = counterbody_deforms},
          .widest = {{-phi, phi}, {-theta, theta}}};
}

BodyShape shape_of(const CoatedSphere& sphere) {
  const double radius = outer_radius(sphere);
  return {
      .layers = named(sphere.layers), .curvatures = {.along = 1.0 / radius, .across = 1.0 / radius}, .radius = radius};
}

class SphereBody final : public RoundBody {
 public:
  explicit SphereBody(const CoatedSphere& sphere) : RoundBody(shape_of(sphere)), sphere_(sphere) {}

  [[nodiscard]] std::string_view name() const override { return "ball"; }
  [[nodiscard]] BodySurface surface(const ContactKinematics& kinematics) const override {
    return surface_of(sphere_, kinematics);
  }
  [[nodiscard]] LayeredBody layered(const ContactKinematics& kinematics) const override {
    return layered_body(sphere_, kinematics.curvature);
  }
  [[nodiscard]] Profile profile(const SurfaceWindow& points) const override { return profile_of(radius(), points); }
  [[nodiscard]] Nodes nodes(const Mesh& mesh, const Body& on) const override {
    return nodes_of(radius(), mesh, !on.is_rigid());
  }

 private:
  CoatedSphere sphere_;
};

}  // namespace

std::unique_ptr<const RoundBody> make_body(const CoatedSphere& sphere) { return std::make_unique<SphereBody>(sphere); }

}  // namespace viscoroll::detail
