// Dimensions and input checks of bodies: layers, balls, rollers, wheels, planes and grooves.
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/validate.hpp"
#include "modal/layer_stack.hpp"
#include "modal/layered_body.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll {
namespace {

/// Sum of the thicknesses of all layers [m].
double thickness_of(std::span<const Layer> layers) {
  double thickness = 0.0;
  for (const Layer& layer : layers) thickness += layer.thickness;
  return thickness;
}

std::string layer_name(std::size_t j) { return "layers[" + std::to_string(j) + "]."; }

/// Check each layer.
void require_layers(std::span<const Layer> layers) {
  for (std::size_t j = 0; j < layers.size(); ++j) validate(layers[j], layer_name(j));
}

/// Check that the layers and the core are not too small relative to the body (`kLargestLengthRatio`).
/// @param[in] layers checked layers of a ball, roller or wheel
/// @param[in] core_radius radius of the core [m]; 0 for a solid ball
void require_lengths(std::span<const Layer> layers, double core_radius) {
  double radius = core_radius;
  for (const Layer& layer : layers) radius += layer.thickness;
  if (core_radius != 0.0) detail::require_length("core_radius", core_radius, radius, "the body");
  for (std::size_t j = 0; j < layers.size(); ++j) {
    detail::require_length(layer_name(j) + "thickness", layers[j].thickness, radius, "the body");
  }
}

/// Layer with the material of a half-space, whose checks are those of a layer of any thickness.
Layer as_layer(const HalfSpace& base) {
  return {.thickness = 1.0,
          .shear_modulus = base.shear_modulus,
          .poisson_ratio = base.poisson_ratio,
          .bulk_modulus = base.bulk_modulus,
          .density = base.density};
}

}  // namespace

void validate(const Layer& layer, std::string_view prefix) {
  const std::string base(prefix);
  detail::require_positive(base + "thickness", layer.thickness, "m");
  detail::require_nonnegative(base + "density", layer.density, "kg/m^3");
  validate(layer.shear_modulus, base + "shear_modulus.");
  if (layer.poisson_ratio.has_value() == layer.bulk_modulus.has_value()) {
    detail::reject(base + "poisson_ratio or " + base + "bulk_modulus", "given, and not both",
                   layer.poisson_ratio ? "both" : "none");
  }
  if (layer.poisson_ratio) {
    detail::require_in({.minimum = -1.0, .maximum = 0.5, .excludes_minimum = true}, base + "poisson_ratio",
                       *layer.poisson_ratio);
  }
  if (layer.bulk_modulus) detail::require_positive(base + "bulk_modulus", *layer.bulk_modulus, "Pa");
}

double coating_thickness(const CoatedSphere& sphere) { return thickness_of(sphere.layers); }

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
  require_layers(sphere.layers);
  require_lengths(sphere.layers, sphere.core_radius);
}

double coating_thickness(const CoatedCylinder& cylinder) { return thickness_of(cylinder.layers); }

double outer_radius(const CoatedCylinder& cylinder) { return cylinder.core_radius + coating_thickness(cylinder); }

void validate(const CoatedCylinder& cylinder) {
  if (cylinder.core_radius == 0.0) {
    detail::reject("core_radius", Range{.unit = "m", .minimum = 0.0, .excludes_minimum = true}, cylinder.core_radius,
                   " (without a core a roller under a line load has no finite compliance)");
  }
  detail::require_positive("core_radius", cylinder.core_radius, "m");
  require_layers(cylinder.layers);
  require_lengths(cylinder.layers, cylinder.core_radius);
}

double coating_thickness(const CoatedWheel& wheel) { return thickness_of(wheel.layers); }

double outer_radius(const CoatedWheel& wheel) { return wheel.core_radius + coating_thickness(wheel); }

double crown_drop(const CoatedWheel& wheel, double z) { return detail::drop_of_circle(z, 1.0 / wheel.crown_radius); }

void validate(const CoatedWheel& wheel) {
  if (wheel.core_radius == 0.0) {
    detail::reject("core_radius", Range{.unit = "m", .minimum = 0.0, .excludes_minimum = true}, wheel.core_radius,
                   " (without a hub a wheel bends as a beam and has no finite compliance)");
  }
  detail::require_positive("core_radius", wheel.core_radius, "m");
  detail::require_positive("width", wheel.width, "m");
  require_layers(wheel.layers);
  require_lengths(wheel.layers, wheel.core_radius);
  const double radius = outer_radius(wheel);
  detail::require_length("width", wheel.width, radius, "the body");
  constexpr double kWidest = 1000.0;
  if (wheel.width > kWidest * radius) {
    detail::reject("width",
                   "at most " + detail::text(kWidest) + " times the outer radius, " + detail::text(kWidest * radius) +
                       " m (use CoatedCylinder for a body without faces)",
                   detail::text(wheel.width) + " m", Range{.unit = "m", .maximum = kWidest * radius});
  }
  // The narrower side of the section determines the size of all elements in the layers.
  constexpr double kThickest = 1000.0;
  const double thickness = coating_thickness(wheel);
  if (wheel.sides == Sides::free && thickness > kThickest * wheel.width) {
    detail::reject("width",
                   "at least " + detail::text(1.0 / kThickest) + " of the thickness of the layers, " +
                       detail::text(thickness / kThickest) + " m, if the sides are free",
                   detail::text(wheel.width) + " m", Range{.unit = "m", .minimum = thickness / kThickest});
  }
  if (!(wheel.crown_radius >= 0.5 * wheel.width)) {
    detail::reject("crown_radius", "at least half of the width, " + detail::text(0.5 * wheel.width) + " m",
                   detail::text(wheel.crown_radius) + " m", Range{.unit = "m", .minimum = 0.5 * wheel.width});
  }
  // The effect of the crown on the layers is a difference of compliances. Beyond this radius it is round-off, which no
  // series resolves.
  constexpr double kFlattest = 1e6;
  if (std::isfinite(wheel.crown_radius) && wheel.crown_radius > kFlattest * radius) {
    detail::reject("crown_radius",
                   "at most " + detail::text(kFlattest) + " times the outer radius, " +
                       detail::text(kFlattest * radius) + " m, or infinite (straight)",
                   detail::text(wheel.crown_radius) + " m", Range{.unit = "m", .maximum = kFlattest * radius});
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

double coating_thickness(const CoatedPlane& plane) { return thickness_of(plane.layers); }

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
  require_layers(plane.layers);
  if (plane.base) validate(as_layer(*plane.base), "base.");
}

}  // namespace viscoroll
