// Wheel, as the rolling body or the counterbody, in point contact that may reach its side faces: docs/theory/wheels.md.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "rolling/body.hpp"
#include "rolling/contact_surface.hpp"
#include "rolling/free_side_tables.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMinColumns = 4;  // on either side of the middle, so that coarsened meshes have columns as well

void require_wheel_options(const Options& options) {
  if (options.patch_load != PatchLoad::flat) reject("patch_load", "FLAT for a wheel", "SPHERICAL");
}

void require_curvature_of_wheel(Curvature curvature) {
  if (curvature == Curvature::sphere) return;
  reject("curvature", "left out for a wheel, whose equations contain the full curvature along the path",
         curvature == Curvature::exact ? "EXACT" : "PAPER");
}

bool has_free_sides(const CoatedWheel& wheel) { return wheel.sides == Sides::free && !wheel.layers.empty(); }

LayeredBody layers_of(const CoatedWheel& wheel, const SurfaceMotion& motion) {
  require_curvature_of_wheel(motion.curvature);
  return layered_body(wheel);
}

/// Surface of the unbounded tread, with the effect of the faces if these are free.
BodySurface surface_of(const CoatedWheel& wheel, const ContactKinematics& kinematics) {
  const LayeredBody layers = layers_of(wheel, kinematics);
  if (wheel.layers.empty()) return {};
  BodySurface surface = surface_of_layers(layers, kinematics);
  if (has_free_sides(wheel)) {
    surface.tables = std::make_unique<const FreeSideTables>(std::move(surface.tables), wheel, layers, kinematics);
  }
  return surface;
}

/// Profile at the same arc lengths as the nodes of the rolling body.
Profile profile_of(const CoatedWheel& wheel, const SurfaceWindow& points) {
  const double radius = outer_radius(wheel);
  const Eigen::ArrayXd forward = (std::numbers::pi / 2.0 - points.phi()) * (points.grid().radius / radius);
  const Eigen::ArrayXd crown = points.z().unaryExpr([&](double z) { return crown_drop(wheel, z); });
  return {.drop = crown + 2.0 * (radius - crown) * (0.5 * forward).sin().square(),
          .slope = (1.0 - crown / radius) * forward.sin()};
}

/// Nodes with columns of equal width. Their width is as close to the spacing of the mesh as is possible with an odd
/// number of columns that ends at the side faces.
Nodes nodes_of(const CoatedWheel& wheel, const Mesh& mesh, const Body& on) {
  const double radius = outer_radius(wheel);
  const double width = std::min(wheel.width, on.width());
  const double columns = width / (radius * theta_spacing(mesh));
  const int aside = std::max(kMinColumns, static_cast<int>(std::lround(0.5 * (columns - 1.0))));
  const int phi = nodes_to_60_degrees(mesh.nodes_per_revolution);
  return {.grid = {.radius = radius,
                   .phi_spacing = phi_spacing(mesh),
                   .theta_spacing = width / ((2 * aside + 1) * radius),
                   .crown_radius = wheel.crown_radius},
          .widest = {{-phi, phi}, {-aside, aside}}};
}

/// Relative error of the torque of an unbounded tread, as a function of the distance from the contact to the side
/// faces, from finite elements of the section at Poisson's ratio 1/2 (docs/theory/wheels.md).
double error_of_sides(const CoatedWheel& wheel, double across) {
  constexpr double kAtSides = 0.11;
  constexpr double kDecayPerThickness = 2.2;  // exponent per thickness of distance
  return kAtSides * std::exp(-kDecayPerThickness * (0.5 * wheel.width - across) / coating_thickness(wheel));
}

/// Relative error of the torque due to the crown, and due to a thickness that is taken as equal everywhere. With free
/// sides, the section includes both.
double error_of_crown(const CoatedWheel& wheel, const ContactReach& contact) {
  if (std::isinf(wheel.crown_radius)) return 0.0;
  const double slope = contact.across / wheel.crown_radius;
  if (wheel.sides == Sides::free) return slope * slope;
  // Change of the torque in first order of the curvature; the remaining error is a sixth to a twentieth of it.
  constexpr double kFirstOrder = 0.17;
  // A tread that becomes thinner towards its faces acts like one of the thickness h - 0.1 a^2 / R_c. The relative
  // change of the torque is twice that of the thickness.
  constexpr double kThinner = 0.2;
  const double thickness = coating_thickness(wheel);
  const double size = std::sqrt(contact.along * contact.across);
  const double profile = wheel.hub == Hub::straight ? kThinner * slope * contact.across / thickness : 0.0;
  return kFirstOrder * std::min(thickness, size) / wheel.crown_radius + slope * slope + profile;
}

double error_of(const CoatedWheel& wheel, const ContactReach& contact) {
  if (wheel.layers.empty()) return 0.0;
  return error_of_crown(wheel, contact) +
         (wheel.sides == Sides::unbounded ? error_of_sides(wheel, contact.across) : 0.0);
}

std::string contact_near_sides(const CoatedWheel& wheel, double across) {
  const double clear = 0.5 * wheel.width - across;
  return "the contact ends " + rounded(clear) + " m from the faces, closer than the tread thickness of " +
         rounded(coating_thickness(wheel)) + " m: with unbounded sides the torque may be too small by a fraction of " +
         rounded(error_of_sides(wheel, across));
}

std::vector<Warning> warnings_of(const CoatedWheel& wheel, const ContactReach& contact, bool other_deforms) {
  std::vector<Warning> warnings;
  const auto add = [&warnings](WarningKind kind, std::string message) {
    warnings.push_back({kind, std::move(message)});
  };
  const double thickness = coating_thickness(wheel);
  const double clear = 0.5 * wheel.width - contact.across;
  const bool is_crowned = std::isfinite(wheel.crown_radius);
  const bool is_unbounded = wheel.sides == Sides::unbounded && !wheel.layers.empty();
  const bool reaches_sides = clear < 1e-9 * wheel.width;
  if (!is_crowned && reaches_sides && (is_unbounded || other_deforms)) {
    const std::string punch = is_unbounded ? "tread with unbounded sides" : "wheel on a wider deformable counterbody";
    add(WarningKind::edge_pressure, "the pressure of a flat " + punch + " is singular at its edges, z = +-" +
                                        rounded(0.5 * wheel.width) + " m: max_pressure depends on the mesh");
  }
  if (is_crowned && reaches_sides) {
    add(WarningKind::contact_at_side,
        "the contact reaches the faces of the crowned tread, z = +-" + rounded(0.5 * wheel.width) + " m");
  } else if (is_crowned && is_unbounded && clear < thickness) {
    add(WarningKind::contact_at_side, contact_near_sides(wheel, contact.across));
  }
  if (wheel.crown_radius < thickness) {
    add(WarningKind::tight_crown, "the crown radius of " + rounded(wheel.crown_radius) +
                                      " m is smaller than the tread thickness of " + rounded(thickness) +
                                      " m: the result is accurate only if the contact is small compared with both");
  }
  return warnings;
}

void require_gentle_crown(const CoatedWheel& wheel) {
  const double thickness = coating_thickness(wheel);
  if (wheel.sides == Sides::free || wheel.crown_radius >= thickness) return;
  reject(
      "crown_radius",
      "at least the tread thickness, " + rounded(thickness) +
          " m: sides = UNBOUNDED includes the crown to first order only, in which a rounder crown rises under pressure "
          "(sides = FREE includes it fully)",
      text(wheel.crown_radius) + " m");
}

BodyShape shape_of(const CoatedWheel& wheel) {
  const double radius = outer_radius(wheel);
  return {.layers = named(wheel.layers),
          .curvatures = {.along = 1.0 / radius, .across = 1.0 / wheel.crown_radius},
          .radius = radius,
          .width = wheel.width};
}

class WheelBody final : public RoundBody {
 public:
  explicit WheelBody(const CoatedWheel& wheel) : RoundBody(shape_of(wheel)), wheel_(wheel) {}

  [[nodiscard]] std::string_view name() const override { return "wheel"; }
  [[nodiscard]] BodySurface surface(const ContactKinematics& kinematics) const override {
    return surface_of(wheel_, kinematics);
  }
  [[nodiscard]] LayeredBody layered(const SurfaceMotion& motion) const override { return layers_of(wheel_, motion); }
  [[nodiscard]] Profile profile(const SurfaceWindow& points) const override { return profile_of(wheel_, points); }
  [[nodiscard]] const CoatedWheel* free_tread() const override { return has_free_sides(wheel_) ? &wheel_ : nullptr; }
  [[nodiscard]] double further_error(const ContactReach& contact) const override { return error_of(wheel_, contact); }
  [[nodiscard]] std::vector<Warning> warnings(const ContactReach& contact, bool other_deforms) const override {
    return warnings_of(wheel_, contact, other_deforms);
  }
  void require_stiffness() const override { require_gentle_crown(wheel_); }
  [[nodiscard]] Nodes nodes(const Mesh& mesh, const Body& on) const override { return nodes_of(wheel_, mesh, on); }
  void require(const Options& options) const override { require_wheel_options(options); }

 private:
  CoatedWheel wheel_;
};

}  // namespace

std::unique_ptr<const RoundBody> make_body(const CoatedWheel& wheel) { return std::make_unique<WheelBody>(wheel); }

}  // namespace viscoroll::detail
