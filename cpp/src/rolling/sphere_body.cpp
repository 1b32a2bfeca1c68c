// Ball, as the rolling body or the counterbody, in point contact: translation-invariant tables of the orders (m, n), or
// those of the exact sphere.
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "base/validate.hpp"
#include "rolling/body.hpp"
#include "rolling/contact_surface.hpp"
#include "rolling/sphere_tables.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

/// Inertia couples neighboring degrees of the exact sphere. It is left out if it is negligible; otherwise the speed is
/// rejected.
LayeredBody without_inertia(LayeredBody body, double angular_speed) {
  constexpr double kNegligible = 1e-3;  // of rho (Omega r_o)^2 / |modulus|; the torque changes by less
  const double speed = angular_speed * body.metric.radius;
  for (std::size_t l = 0; l < body.layers.size(); ++l) {
    Layer& layer = body.layers[l];
    const double relaxed = modulus_in_rolling(layer.shear_modulus, angular_speed, std::array{0.0}).front().real();
    const double share = layer.density * speed * speed / relaxed;
    if (share > kNegligible) {
      reject("layers[" + std::to_string(l) + "].density",
             "so small that inertia is negligible with curvature EXACT, at most " +
                 text(layer.density * kNegligible / share) + " kg/m^3 at this speed",
             text(layer.density) + " kg/m^3");
    }
    layer.density = 0.0;
  }
  return body;
}

/// Surface of the exact sphere, without inertia.
BodySurface surface_of_exact_sphere(const CoatedSphere& sphere, const ContactKinematics& kinematics) {
  const double radius = outer_radius(sphere);
  const double speed = kinematics.angular_speed_at(radius);
  const MeshOnBody mesh = kinematics.mesh_at(radius);
  const LayeredBody layers = without_inertia(layered_body(sphere), speed);
  return surface_of_layers(layers, kinematics,
                           std::make_unique<const SphereTables>(SphereSum(layers, speed, mesh), mesh.rounded()));
}

BodySurface surface_of(const CoatedSphere& sphere, const ContactKinematics& kinematics) {
  if (sphere.layers.empty()) return {};
  if (kinematics.curvature == Curvature::exact) return surface_of_exact_sphere(sphere, kinematics);
  return surface_of_layers(layered_body(sphere, kinematics.curvature), kinematics);
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
  [[nodiscard]] LayeredBody layered(const SurfaceMotion& motion) const override {
    return layered_body(sphere_, motion.curvature);
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
