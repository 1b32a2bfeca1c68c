// A plane, or a groove whose layers are a plane's, under a spot or a line: theory.md sections 14 and 15.
#include <string>
#include <utility>

#include "rolling/body.hpp"
#include "rolling/line_surface.hpp"
#include "rolling/spot_surface.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// Of what rolls in a groove, radius by radius: in a closer one contact is no longer shallow.
constexpr double kClosestFit = 1.0 / 1.02;

BodySurface surface_of(const CoatedPlane& plane, const Crossing& crossing) {
  if (is_rigid(plane)) return {};
  const LayeredBody layers = layered_body(plane, crossing.radius);
  return crossing.form.is_line() ? surface_under_line(layers, crossing) : surface_under_spot(layers, crossing);
}

/// @param[in] hollow_radius > 0 where the surface is hollow [m]; none: straight
double curvature(const std::optional<double>& hollow_radius) { return hollow_radius ? -1.0 / *hollow_radius : 0.0; }

/// @param[in] own curvature of what rolls [1/m]
void require_room(std::string_view name, double curvature, const Body& body, double own) {
  if (-curvature <= kClosestFit * own) return;
  const std::string room = own > 0.0 ? "larger than that of the " + std::string(body.name) + ", " + text(1.0 / own) +
                                           " m, by 2 % at the least"
                                     : "left out under a flat " + std::string(body.name);
  reject(name, room, text(-1.0 / curvature) + " m");
}

/// The height of what rolls along it, so many times: the gap's slope along the nodes is x over the relative radius.
Profile under_line(double curvature, const SurfaceWindow& points) {
  return {.drop = curvature * points.grid().radius * points.height(), .slope = curvature * points.x()};
}

/// Along a line only the path may be curved.
void require_straight_across(const Body& body, const std::optional<double>& radius) {
  if (!radius || !body.form.is_line()) return;
  reject("on.radius", "left out under a cylinder, which touches along a line", text(*radius) + " m");
}

}  // namespace

Body make_body(const CoatedPlane& plane) {
  std::vector<NamedLayer> layers = named(plane.layers);
  if (plane.base) layers.insert(layers.begin(), {.name = "base", .layer = layers_from_base(plane).front()});
  return {.type = "CoatedPlane",
          .layers = std::move(layers),
          .curvatures = {},
          .surface = [plane](const Crossing& crossing) { return surface_of(plane, crossing); },
          .layered = [plane](const Crossing& crossing) { return layered_body(plane, crossing.radius); },
          .profile = circles({})};
}

Body make_body(const Groove& groove) {
  Body body = make_body(groove.surface);
  const Curvatures curvatures{.along = curvature(groove.path_radius), .across = curvature(groove.radius)};
  body.type = "Groove";
  body.curvatures = curvatures;
  body.profile = [curvatures](const SurfaceWindow& points) {
    return points.window().is_line() ? under_line(curvatures.along, points) : circles(curvatures)(points);
  };
  body.require_room_for = [curvatures, across = groove.radius](const Body& rolling) {
    require_straight_across(rolling, across);
    require_room("on.radius", curvatures.across, rolling, rolling.curvatures.across);
    require_room("on.path_radius", curvatures.along, rolling, rolling.curvatures.along);
  };
  return body;
}

}  // namespace viscoroll::detail
