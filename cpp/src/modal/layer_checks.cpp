#include "modal/layer_checks.hpp"

#include <cstddef>
#include <string>

#include "base/validate.hpp"

namespace viscoroll {

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

namespace detail {
namespace {

std::string layer_name(std::size_t j) { return "layers[" + std::to_string(j) + "]."; }

}  // namespace

void require_layers(std::span<const Layer> layers) {
  for (std::size_t j = 0; j < layers.size(); ++j) validate(layers[j], layer_name(j));
}

void require_lengths(std::span<const Layer> layers, double core_radius) {
  double radius = core_radius;
  for (const Layer& layer : layers) radius += layer.thickness;
  if (core_radius != 0.0) require_length("core_radius", core_radius, radius, "the body");
  for (std::size_t j = 0; j < layers.size(); ++j) {
    require_length(layer_name(j) + "thickness", layers[j].thickness, radius, "the body");
  }
}

}  // namespace detail
}  // namespace viscoroll
