#include "viscoroll/wheel.hpp"

#include <cmath>
#include <string>

#include "base/validate.hpp"
#include "modal/circle.hpp"
#include "modal/layer_checks.hpp"

namespace viscoroll {

double coating_thickness(const CoatedWheel& wheel) {
  double thickness = 0.0;
  for (const Layer& layer : wheel.layers) thickness += layer.thickness;
  return thickness;
}

double outer_radius(const CoatedWheel& wheel) { return wheel.core_radius + coating_thickness(wheel); }

double crown_drop(const CoatedWheel& wheel, double z) { return detail::drop_of_circle(z, 1.0 / wheel.crown_radius); }

void validate(const CoatedWheel& wheel) {
  if (wheel.core_radius == 0.0) {
    detail::reject("core_radius", "> 0 m (without a hub a wheel bends as a beam and has no finite compliance)",
                   wheel.core_radius);
  }
  detail::require_positive("core_radius", wheel.core_radius, "m");
  detail::require_positive("width", wheel.width, "m");
  detail::require_layers(wheel.layers);
  detail::require_lengths(wheel.layers, wheel.core_radius);
  const double radius = outer_radius(wheel);
  detail::require_length("width", wheel.width, radius, "the body");
  constexpr double kWidest = 1000.0;
  if (wheel.width > kWidest * radius) {
    detail::reject("width",
                   "at most " + detail::text(kWidest) + " times the outer radius, " + detail::text(kWidest * radius) +
                       " m (use CoatedCylinder for a body without faces)",
                   detail::text(wheel.width) + " m");
  }
  // The narrower side of the section determines the size of all elements in the layers.
  constexpr double kThickest = 1000.0;
  const double thickness = coating_thickness(wheel);
  if (wheel.sides == Sides::free && thickness > kThickest * wheel.width) {
    detail::reject("width",
                   "at least " + detail::text(1.0 / kThickest) + " of the thickness of the layers, " +
                       detail::text(thickness / kThickest) + " m, if the sides are free",
                   detail::text(wheel.width) + " m");
  }
  if (!(wheel.crown_radius >= 0.5 * wheel.width)) {
    detail::reject("crown_radius", "at least half of the width, " + detail::text(0.5 * wheel.width) + " m",
                   detail::text(wheel.crown_radius) + " m");
  }
  // The effect of the crown on the layers is a difference of compliances. Beyond this radius it is round-off, which no
  // series resolves.
  constexpr double kFlattest = 1e6;
  if (std::isfinite(wheel.crown_radius) && wheel.crown_radius > kFlattest * radius) {
    detail::reject("crown_radius",
                   "at most " + detail::text(kFlattest) + " times the outer radius, " +
                       detail::text(kFlattest * radius) + " m, or infinite (straight)",
                   detail::text(wheel.crown_radius) + " m");
  }
  const double drop = crown_drop(wheel, 0.5 * wheel.width);
  const bool has_straight_hub = wheel.hub == Hub::straight && !wheel.layers.empty();
  const double most = has_straight_hub ? wheel.layers.back().thickness : radius;
  if (!(drop < most)) {
    detail::reject(
        "crown_radius",
        "so large that the crown drops at the faces by less than " + detail::text(most) + " m, the " +
            (has_straight_hub ? "thickness of the outermost layer (with hub=\"crowned\" the layers follow the crown)"
                              : "outer radius"),
        detail::text(wheel.crown_radius) + " m, with which it drops by " + detail::text(drop) + " m");
  }
}

}  // namespace viscoroll
