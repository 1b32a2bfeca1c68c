#include "modal/layered_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// Where layers lie about a center.
std::vector<double> radii(double inner, const std::vector<Layer>& layers) {
  std::vector<double> boundaries{inner};
  for (const Layer& layer : layers) boundaries.push_back(boundaries.back() + layer.thickness);
  return boundaries;
}

/// Thicknesses in the radius of the crown from which on it is the cylinder of its radius; rounder ones may have no hub.
constexpr double kLeastRadius = 3.0;

/// Those in the radius of the cylinder that stands for rounder ones, in proportion to the curvature.
constexpr double kLinearRadius = 20.0;

/// Where the section has the crown as it is: so flat that the difference is linear, as that which is taken off there.
constexpr double kLinearRadiusOfSection = 100.0;

Crown crown_of(const CoatedWheel& wheel) {
  const double thickness = coating_thickness(wheel);
  const auto told_from = [&](double radius) {
    return Crown{.radius = radius, .proportion = radius / wheel.crown_radius};
  };
  if (std::isinf(wheel.crown_radius)) return {};
  if (wheel.sides == Sides::free) return told_from(std::max(wheel.crown_radius, kLinearRadiusOfSection * thickness));
  return told_from(wheel.crown_radius > kLeastRadius * thickness ? wheel.crown_radius : kLinearRadius * thickness);
}

/// Where layers lie below a plane.
std::vector<double> heights(const std::vector<Layer>& layers) {
  std::vector<double> boundaries(layers.size() + 1, 0.0);
  for (std::size_t j = layers.size(); j-- > 0;) boundaries[j] = boundaries[j + 1] - layers[j].thickness;
  return boundaries;
}

}  // namespace

std::vector<Layer> layers_from_base(const CoatedPlane& plane) {
  std::vector<Layer> layers = plane.layers;
  if (plane.base) {
    layers.insert(layers.begin(), {.thickness = std::numeric_limits<double>::infinity(),
                                   .shear_modulus = plane.base->shear_modulus,
                                   .poisson_ratio = plane.base->poisson_ratio,
                                   .bulk_modulus = plane.base->bulk_modulus,
                                   .density = plane.base->density});
  }
  return layers;
}

LayeredBody layered_body(const CoatedSphere& sphere, Curvature curvature) {
  validate(sphere);
  return {.metric = {.radius = outer_radius(sphere), .curvature = curvature},
          .layers = sphere.layers,
          .within = sphere.inner_boundary,
          .boundaries = radii(sphere.core_radius, sphere.layers)};
}

LayeredBody layered_body(const CoatedCylinder& cylinder) {
  validate(cylinder);
  return {.metric = {.radius = outer_radius(cylinder), .across = Way::nothing},
          .layers = cylinder.layers,
          .boundaries = radii(cylinder.core_radius, cylinder.layers)};
}

LayeredBody layered_body(const CoatedWheel& wheel) {
  validate(wheel);
  return {.metric = {.radius = outer_radius(wheel), .across = Way::line},
          .layers = wheel.layers,
          .boundaries = radii(wheel.core_radius, wheel.layers),
          .crown = crown_of(wheel)};
}

LayeredBody layered_body(const CoatedPlane& plane, double radius) {
  validate(plane);
  require_positive("radius", radius, "m");
  std::vector<Layer> layers = layers_from_base(plane);
  std::vector<double> boundaries = heights(layers);
  return {.metric = {.radius = radius, .along = Way::line, .across = Way::line},
          .layers = std::move(layers),
          .boundaries = std::move(boundaries)};
}

}  // namespace viscoroll::detail
