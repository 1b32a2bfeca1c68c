#include "viscoroll/sphere.hpp"

#include <cmath>
#include <string>

#include "modal/inner_boundary.hpp"
#include "validate.hpp"

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

void validate(const Layer& layer, std::string_view prefix) {
  const std::string base(prefix);
  detail::require_positive(base + "thickness", layer.thickness, "m");
  detail::require_nonnegative(base + "density", layer.density, "kg/m^3");
  validate(layer.shear_modulus, base + "shear_modulus.");
  if (layer.poisson_ratio.has_value() == layer.bulk_modulus.has_value()) {
    detail::reject(base + "poisson_ratio or " + base + "bulk_modulus", "given, and not both",
                   layer.poisson_ratio ? "both" : "none");
  }
  if (layer.poisson_ratio && !(*layer.poisson_ratio > -1.0 && *layer.poisson_ratio <= 0.5)) {
    detail::reject(base + "poisson_ratio", "in (-1, 0.5]", *layer.poisson_ratio);
  }
  if (layer.bulk_modulus) detail::require_positive(base + "bulk_modulus", *layer.bulk_modulus, "Pa");
}

void validate(const CoatedSphere& sphere) {
  const detail::InnerSurface inner = detail::inner_surface(sphere.inner_boundary);
  if (inner.exists()) {
    detail::require_positive("core_radius", sphere.core_radius, "m");
  } else if (sphere.core_radius != 0.0) {
    detail::reject("core_radius", "0 m in a solid ball", sphere.core_radius);
  }
  if (sphere.layers.empty() && !inner.is_core) {
    detail::reject("layers", "a list of at least one layer without a rigid core", "none");
  }
  for (std::size_t j = 0; j < sphere.layers.size(); ++j) {
    validate(sphere.layers[j], "layers[" + std::to_string(j) + "].");
  }
  const double radius = outer_radius(sphere);
  if (!std::isfinite(radius)) detail::reject("outer radius", "finite", radius);
}

}  // namespace viscoroll
