#include "viscoroll/plane.hpp"

#include <cmath>

#include "base/validate.hpp"
#include "modal/layer_checks.hpp"

namespace viscoroll {
namespace {

/// Layer with the material of a half-space, whose checks are those of a layer of any thickness.
Layer as_layer(const HalfSpace& base) {
  return {.thickness = 1.0,
          .shear_modulus = base.shear_modulus,
          .poisson_ratio = base.poisson_ratio,
          .bulk_modulus = base.bulk_modulus,
          .density = base.density};
}

}  // namespace

double coating_thickness(const CoatedPlane& plane) {
  double thickness = 0.0;
  for (const Layer& layer : plane.layers) thickness += layer.thickness;
  return thickness;
}

bool is_rigid(const CoatedPlane& plane) { return plane.layers.empty() && !plane.base; }

bool is_rigid(const Groove& groove) { return is_rigid(groove.surface); }

void validate(const Groove& groove) {
  const auto require_curved = [](const char* name, const std::optional<double>& radius) {
    if (!radius) return;
    if (*radius != 0.0 && std::isfinite(*radius)) return;
    detail::reject(name, "finite and nonzero, or left out if the groove is straight in this direction",
                   detail::text(*radius) + " m");
  };
  require_curved("groove.radius", groove.radius);
  require_curved("groove.path_radius", groove.path_radius);
  if (!groove.radius && !groove.path_radius) {
    detail::reject("groove.radius or groove.path_radius",
                   "given (use CoatedPlane for a surface that is straight in both directions)", "neither");
  }
  validate(groove.surface);
}

void validate(const CoatedPlane& plane) {
  detail::require_layers(plane.layers);
  if (plane.base) validate(as_layer(*plane.base), "base.");
}

}  // namespace viscoroll
