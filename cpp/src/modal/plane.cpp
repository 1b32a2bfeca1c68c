#include "viscoroll/plane.hpp"

#include <string>

namespace viscoroll {
namespace {

/// Its checks are those of a layer of any thickness.
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

void validate(const CoatedPlane& plane) {
  for (std::size_t j = 0; j < plane.layers.size(); ++j) {
    validate(plane.layers[j], "plane.layers[" + std::to_string(j) + "].");
  }
  if (plane.base) validate(as_layer(*plane.base), "plane.base.");
}

}  // namespace viscoroll
