// Roller, as the rolling body or the counterbody, in line contact or under a wheel: docs/theory/rollers.md.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "rolling/body.hpp"
#include "rolling/contact_surface.hpp"

namespace viscoroll::detail {
namespace {

/// A line contact has a single row of nodes without lateral spacing; nodal forces are forces per length.
void require_line_mesh(const Mesh& mesh) {
  if (mesh.theta_nodes_per_revolution) {
    reject("mesh.theta_nodes_per_revolution", "left out for a roller, whose contact is a single row of nodes",
           std::to_string(*mesh.theta_nodes_per_revolution));
  }
}

void require_curvature_of_cylinder(Curvature curvature) {
  if (curvature == Curvature::sphere) return;
  reject("curvature", "left out for a roller, whose equations contain the full curvature",
         curvature == Curvature::exact ? "EXACT" : "PAPER");
}

/// Layers of the roller; under a wheel they are a tread without side faces.
LayeredBody layers_of(const CoatedCylinder& cylinder, const SurfaceMotion& motion) {
  require_curvature_of_cylinder(motion.curvature);
  LayeredBody layers = layered_body(cylinder);
  if (!motion.form.is_line()) layers.metric.across = AxisKind::line;
  return layers;
}

BodySurface surface_of(const CoatedCylinder& cylinder, const ContactKinematics& kinematics) {
  const LayeredBody layers = layers_of(cylinder, kinematics);
  return cylinder.layers.empty() ? BodySurface{} : surface_of_layers(layers, kinematics);
}

/// Profile at the same arc lengths as the nodes of the rolling body.
Profile profile_of(double radius, const SurfaceWindow& points) {
  const Eigen::ArrayXd forward = (std::numbers::pi / 2.0 - points.phi()) * (points.grid().radius / radius);
  return {.drop = 2.0 * radius * (0.5 * forward).sin().square(), .slope = forward.sin()};
}

/// The patch of a node is one meter wide, so that nodal forces are forces per length.
Nodes nodes_of(double radius, const Mesh& mesh) {
  require_line_mesh(mesh);
  const int phi = nodes_to_60_degrees(mesh.nodes_per_revolution);
  return {.grid = {.radius = radius, .phi_spacing = phi_spacing(mesh), .theta_spacing = 1.0 / radius},
          .widest = {{-phi, phi}, {0, 0}}};
}

void require_flat_patches(const Options& options) {
  if (options.patch_load != PatchLoad::flat) reject("patch_load", "FLAT for a roller", "SPHERICAL");
}

BodyShape shape_of(const CoatedCylinder& cylinder) {
  const double radius = outer_radius(cylinder);
  return {.layers = named(cylinder.layers), .curvatures = {.along = 1.0 / radius}, .radius = radius};
}

class CylinderBody final : public RoundBody {
 public:
  explicit CylinderBody(const CoatedCylinder& cylinder) : RoundBody(shape_of(cylinder)), cylinder_(cylinder) {}

  [[nodiscard]] std::string_view name() const override { return "roller"; }
  [[nodiscard]] const ContactForm& form() const override { return kLineContact; }
  [[nodiscard]] BodySurface surface(const ContactKinematics& kinematics) const override {
    return surface_of(cylinder_, kinematics);
  }
  [[nodiscard]] LayeredBody layered(const SurfaceMotion& motion) const override { return layers_of(cylinder_, motion); }
  [[nodiscard]] Profile profile(const SurfaceWindow& points) const override { return profile_of(radius(), points); }
  [[nodiscard]] Nodes nodes(const Mesh& mesh, const Body& /*on*/) const override { return nodes_of(radius(), mesh); }
  void require(const Options& options) const override { require_flat_patches(options); }

 private:
  CoatedCylinder cylinder_;
};

}  // namespace

std::unique_ptr<const RoundBody> make_body(const CoatedCylinder& cylinder) {
  return std::make_unique<CylinderBody>(cylinder);
}

}  // namespace viscoroll::detail
