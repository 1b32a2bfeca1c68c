#include "viscoroll/wheel.hpp"

#include <cmath>
#include <string>

#include "modal/circle.hpp"
#include "validate.hpp"

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
  for (std::size_t j = 0; j < wheel.layers.size(); ++j) {
    validate(wheel.layers[j], "layers[" + std::to_string(j) + "].");
  }
  const double radius = outer_radius(wheel);
  if (!std::isfinite(radius)) detail::reject("outer radius", "finite", radius);
  if (!(wheel.crown_radius >= 0.5 * wheel.width)) {
    detail::reject("crown_radius", "at least half of the width, " + detail::text(0.5 * wheel.width) + " m",
                   detail::text(wheel.crown_radius) + " m");
  }
  const double drop = crown_drop(wheel, 0.5 * wheel.width);
  const double most = wheel.hub == Hub::straight && !wheel.layers.empty() ? wheel.layers.back().thickness : radius;
  if (!(drop < most)) {
    detail::reject("crown_radius",
                   "so large that the crown stays within the outermost layer up to the faces, " + detail::text(most) +
                       " m, on a straight hub (hub=\"crowned\" has layers that follow it)",
                   detail::text(wheel.crown_radius) + " m, which falls by " + detail::text(drop) + " m");
  }
}

}  // namespace viscoroll
