#include "viscoroll/sphere.hpp"

#include "base/validate.hpp"
#include "modal/inner_boundary.hpp"
#include "modal/layer_checks.hpp"

namespace viscoroll {

double coating_thickness(const CoatedSphere& sphere) {
  double thickness = 0.0;
  for (const Layer& layer : sphere.layers) thickness += layer.thickness;
  return thickness;
}

double outer_radius(const CoatedSphere& sphere) {
  double radius = sphere.core_radius;
  for (const Layer& layer : sphere.layers) radius += layer.thickness;
  return radius;
}

void validate(const CoatedSphere& sphere) {
  const detail::InnerSurface inner = detail::inner_surface(sphere.inner_boundary);
  if (inner.exists()) {
    detail::require_positive("core_radius", sphere.core_radius, "m");
  } else if (sphere.core_radius != 0.0) {
    detail::reject("core_radius", "0 m for a solid ball", sphere.core_radius);
  }
  if (sphere.layers.empty() && !inner.is_core) {
    detail::reject("layers", "a list of at least one layer if the ball has no rigid core", "none");
  }
  detail::require_layers(sphere.layers);
  detail::require_lengths(sphere.layers, sphere.core_radius);
}

}  // namespace viscoroll
