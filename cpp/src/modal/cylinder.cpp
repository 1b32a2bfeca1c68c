#include "viscoroll/cylinder.hpp"

#include "base/validate.hpp"
#include "modal/layer_checks.hpp"

namespace viscoroll {

double coating_thickness(const CoatedCylinder& cylinder) {
  double thickness = 0.0;
  for (const Layer& layer : cylinder.layers) thickness += layer.thickness;
  return thickness;
}

double outer_radius(const CoatedCylinder& cylinder) { return cylinder.core_radius + coating_thickness(cylinder); }

void validate(const CoatedCylinder& cylinder) {
  if (cylinder.core_radius == 0.0) {
    detail::reject("core_radius", "> 0 m (without a core a roller under a line load has no finite compliance)",
                   cylinder.core_radius);
  }
  detail::require_positive("core_radius", cylinder.core_radius, "m");
  detail::require_layers(cylinder.layers);
  detail::require_lengths(cylinder.layers, cylinder.core_radius);
}

}  // namespace viscoroll
