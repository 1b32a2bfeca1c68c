#include "interior/inside.hpp"

#include <utility>

#include "base/validate.hpp"
#include "interior/load_spectrum.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {
namespace {

LayeredBody body_under(const CoatedSphere& sphere, double /*radius*/, bool line, Curvature curvature) {
  require_orders(curvature);
  if (line) reject("tractions.line", "false for a sphere", "true");
  return layered_body(sphere, curvature);
}

LayeredBody body_under(const CoatedCylinder& cylinder, double /*radius*/, bool line, Curvature /*curvature*/) {
  if (!line) reject("tractions.line", "true for a cylinder (if the other body is a wheel, use CoatedWheel)", "false");
  return layered_body(cylinder);
}

LayeredBody body_under(const CoatedWheel& wheel, double /*radius*/, bool line, Curvature /*curvature*/) {
  if (line) reject("tractions.line", "false for a wheel", "true");
  return layered_body(wheel);
}

LayeredBody body_under(const CoatedPlane& plane, double radius, bool line, Curvature /*curvature*/) {
  LayeredBody body = layered_body(plane, radius);
  if (line) body.metric.across = AxisKind::nothing;
  return body;
}

}  // namespace

Inside inside_of(const LayeredShape& shape, double angular_speed, double radius, bool line, Curvature curvature) {
  require_positive("angular_speed", angular_speed, "rad/s");
  require_positive("radius", radius, "m");
  LayeredBody body = std::visit([&](const auto& given) { return body_under(given, radius, line, curvature); }, shape);
  const double own_speed = angular_speed * (radius / body.metric.radius);
  return {.body = std::move(body), .angular_speed = own_speed};
}

Inside inside_of(const LayeredShape& shape, double angular_speed, const Tractions& tractions) {
  validate(tractions);
  return inside_of(shape, angular_speed, tractions.radius, tractions.line, tractions.curvature);
}

}  // namespace viscoroll::detail
