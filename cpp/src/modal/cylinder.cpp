#include "viscoroll/cylinder.hpp"

#include <cmath>
#include <string>

#include "validate.hpp"

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
  for (std::size_t j = 0; j < cylinder.layers.size(); ++j) {
    validate(cylinder.layers[j], "layers[" + std::to_string(j) + "].");
  }
  const double radius = outer_radius(cylinder);
  if (!std::isfinite(radius)) detail::reject("outer radius", "finite", radius);
}

}  // namespace viscoroll
