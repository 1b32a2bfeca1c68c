#include "modal/layered_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace viscoroll::detail {
namespace {

/// Boundaries of layers around a center.
std::vector<double> radii(double inner, const std::vector<Layer>& layers) {
  std::vector<double> boundaries{inner};
  for (const Layer& layer : layers) boundaries.push_back(boundaries.back() + layer.thickness);
  return boundaries;
}

/// Crown radius, in thicknesses, above which the reference is the cylinder of this radius. Cylinders of smaller radii
/// would have almost no hub.
constexpr double kMinReferenceRadius = 3.0;

/// Radius of the reference for smaller crown radii, in thicknesses; the effect is proportional to the curvature.
constexpr double kLinearRadius = 20.0;

/// Least radius of the reference with free sides, in thicknesses. The section contains the actual crown, and an
/// unbounded section that is crowned to first order is subtracted from it. The reference must be linear in the
/// curvature like that unbounded section.
constexpr double kLinearRadiusOfSection = 100.0;

Crown crown_of(const CoatedWheel& wheel) {
  const double thickness = coating_thickness(wheel);
  const auto relative_to = [&](double radius) {
    return Crown{.radius = radius, .proportion = radius / wheel.crown_radius};
  };
  if (std::isinf(wheel.crown_radius)) return {};
  if (wheel.sides == Sides::free) return relative_to(std::max(wheel.crown_radius, kLinearRadiusOfSection * thickness));
  return relative_to(wheel.crown_radius > kMinReferenceRadius * thickness ? wheel.crown_radius
                                                                          : kLinearRadius * thickness);
}

/// Boundaries of layers below a plane.
std::vector<double> heights(const std::vector<Layer>& layers) {
  std::vector<double> boundaries(layers.size() + 1, 0.0);
  for (std::size_t j = layers.size(); j-- > 0;) boundaries[j] = boundaries[j + 1] - layers[j].thickness;
  return boundaries;
}

}  // namespace

double relaxed_modulus(const ShearModulus& modulus) { return complex_modulus(modulus, std::array{0.0}).front().real(); }

void relax_layer(Layer& layer) {
  layer.shear_modulus = Elastic{relaxed_modulus(layer.shear_modulus)};
  layer.density = 0.0;
}

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
  return {.metric = {.radius = outer_radius(sphere), .curvature = curvature},
          .layers = sphere.layers,
          .inner_boundary = sphere.inner_boundary,
          .boundaries = radii(sphere.core_radius, sphere.layers)};
}

LayeredBody layered_body(const CoatedCylinder& cylinder) {
  return {.metric = {.radius = outer_radius(cylinder), .across = AxisKind::nothing},
          .layers = cylinder.layers,
          .boundaries = radii(cylinder.core_radius, cylinder.layers)};
}

LayeredBody layered_body(const CoatedWheel& wheel) {
  return {.metric = {.radius = outer_radius(wheel), .across = AxisKind::line},
          .layers = wheel.layers,
          .boundaries = radii(wheel.core_radius, wheel.layers),
          .crown = crown_of(wheel)};
}

LayeredBody layered_body(const CoatedPlane& plane, double radius) {
  std::vector<Layer> layers = layers_from_base(plane);
  std::vector<double> boundaries = heights(layers);
  return {.metric = {.radius = radius, .along = AxisKind::line, .across = AxisKind::line},
          .layers = std::move(layers),
          .boundaries = std::move(boundaries)};
}

}  // namespace viscoroll::detail
