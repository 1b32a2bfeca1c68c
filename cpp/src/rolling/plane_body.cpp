// Plane, or groove with the layers of a plane, under a point or line contact: docs/theory/rollers.md and
// planes-and-pairs.md.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/validate.hpp"
#include "rolling/body.hpp"
#include "rolling/contact_surface.hpp"

namespace viscoroll::detail {
namespace {

/// Largest ratio of the radius of the rolling body to that of the groove: in a closer fit, the contact is no longer
/// shallow.
constexpr double kClosestFit = 1.0 / 1.02;

/// @param[in] hollow_radius radius of a hollow surface [m], > 0; none for a straight surface
double curvature(const std::optional<double>& hollow_radius) { return hollow_radius ? -1.0 / *hollow_radius : 0.0; }

/// @param[in] own curvature of the rolling body [1/m]
void require_room(std::string_view name, double curvature, const RoundBody& body, double own) {
  if (-curvature <= kClosestFit * own) return;
  const std::string room = own > 0.0 ? "at least 2 % larger than the radius of the " + std::string(body.name()) + ", " +
                                           text(1.0 / own) + " m"
                                     : "left out under a flat " + std::string(body.name());
  reject(name, room, text(-1.0 / curvature) + " m");
}

/// In line contact, only the path may be curved.
void require_straight_across(const RoundBody& body, const std::optional<double>& radius) {
  if (!radius || !body.form().is_line()) return;
  reject("on.radius", "left out under a roller, whose contact is a line", text(*radius) + " m");
}

std::vector<NamedLayer> layers_with_base(const CoatedPlane& plane) {
  std::vector<NamedLayer> layers = named(plane.layers);
  if (plane.base) layers.insert(layers.begin(), {.name = "base", .layer = layers_from_base(plane).front()});
  return layers;
}

class PlaneBody : public Body {
 public:
  explicit PlaneBody(const CoatedPlane& plane, const Curvatures& curvatures = {})
      : Body({.layers = layers_with_base(plane), .curvatures = curvatures}), plane_(plane) {}

  [[nodiscard]] BodySurface surface(const ContactKinematics& kinematics) const override {
    return is_rigid() ? BodySurface{} : surface_of_layers(layered(kinematics), kinematics);
  }
  [[nodiscard]] LayeredBody layered(const SurfaceMotion& motion) const override {
    return layered_body(plane_, motion.radius);
  }
  [[nodiscard]] Profile profile(const SurfaceWindow& points) const override { return circles(curvatures(), points); }

 private:
  CoatedPlane plane_;
};

/// Layers of a plane under a surface that is curved along the path, across it, or both.
class GrooveBody final : public PlaneBody {
 public:
  explicit GrooveBody(const Groove& groove)
      : PlaneBody(groove.surface, {.along = curvature(groove.path_radius), .across = curvature(groove.radius)}),
        radius_across_(groove.radius) {}

  void require_room_for(const RoundBody& rolling) const override {
    require_straight_across(rolling, radius_across_);
    require_room("on.radius", curvatures().across, rolling, rolling.curvatures().across);
    require_room("on.path_radius", curvatures().along, rolling, rolling.curvatures().along);
  }

 private:
  std::optional<double> radius_across_;
};

}  // namespace

std::unique_ptr<const Body> make_body(const CoatedPlane& plane) { return std::make_unique<PlaneBody>(plane); }

std::unique_ptr<const Body> make_body(const Groove& groove) { return std::make_unique<GrooveBody>(groove); }

}  // namespace viscoroll::detail
