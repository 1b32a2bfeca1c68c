#include "rolling/rolling_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "modal/layered_body.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// Of a ball in a groove, radius by radius: in a closer one contact is no longer shallow.
constexpr double kClosestFit = 1.0 / 1.02;

const std::vector<Layer>& layers_of(const RollingBody& body) {
  return std::visit([](const auto& shape) -> const std::vector<Layer>& { return shape.layers; }, body);
}

void append(std::vector<NamedLayer>& named, const std::vector<Layer>& layers, const std::string& name) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    named.push_back({.name = name + "layers[" + std::to_string(i) + "]", .layer = layers[i]});
  }
}

}  // namespace

double outer_radius(const RollingBody& body) {
  return std::visit([](const auto& shape) { return viscoroll::outer_radius(shape); }, body);
}

bool is_roller(const RollingBody& body) { return std::holds_alternative<CoatedCylinder>(body); }

std::string_view name(const RollingBody& body) { return is_roller(body) ? "roller" : "sphere"; }

std::string_view load_unit(const RollingBody& body) { return is_roller(body) ? "N/m" : "N"; }

bool is_rigid(const RollingBody& body) { return layers_of(body).empty(); }

bool is_rigid(const Counterpart& on) {
  if (const auto* roller = std::get_if<CoatedCylinder>(&on)) return roller->layers.empty();
  return viscoroll::is_rigid(plane_of(on));
}

const CoatedPlane& plane_of(const Counterpart& on) {
  const auto* groove = std::get_if<Groove>(&on);
  return groove == nullptr ? std::get<CoatedPlane>(on) : groove->surface;
}

TrackCurvature track_curvature(const Counterpart& on) {
  const auto* groove = std::get_if<Groove>(&on);
  if (groove == nullptr) return {};
  const auto curvature = [](const std::optional<double>& radius) { return radius ? 1.0 / *radius : 0.0; };
  return {.along = curvature(groove->path_radius), .across = curvature(groove->radius)};
}

double radius_of(const Counterpart& on) {
  const auto* roller = std::get_if<CoatedCylinder>(&on);
  return roller == nullptr ? std::numeric_limits<double>::infinity() : viscoroll::outer_radius(*roller);
}

double relative_radius(const RollingPair& pair) {
  const double radius = outer_radius(pair.body);
  return radius / (1.0 + radius / radius_of(pair.on) - radius * track_curvature(pair.on).along);
}

double counterpart_curvature(const RollingPair& pair) {
  return 1.0 / radius_of(pair.on) - track_curvature(pair.on).along;
}

std::vector<NamedLayer> layers(const RollingPair& pair) {
  std::vector<NamedLayer> named;
  append(named, layers_of(pair.body), "");
  if (const auto* roller = std::get_if<CoatedCylinder>(&pair.on)) {
    append(named, roller->layers, "on.");
    return named;
  }
  const CoatedPlane& plane = plane_of(pair.on);
  if (plane.base) named.push_back({.name = "on.base", .layer = layers_from_base(plane).front()});
  append(named, plane.layers, "on.");
  return named;
}

double thickness(const RollingPair& pair) {
  double sum = 0.0;
  for (const NamedLayer& named : layers(pair)) sum += named.layer.thickness;
  return sum;
}

double layer_thickness(const RollingPair& pair) {
  double sum = 0.0;
  for (const NamedLayer& named : layers(pair)) {
    if (std::isfinite(named.layer.thickness)) sum += named.layer.thickness;
  }
  return sum;
}

double half_space_share(const RollingPair& pair) {
  double base = std::numeric_limits<double>::infinity();
  double softest = std::numeric_limits<double>::infinity();
  for (const NamedLayer& named : layers(pair)) {
    const std::array rest{0.0};
    const double modulus = complex_modulus(named.layer.shear_modulus, rest).front().real();
    double& least = std::isinf(named.layer.thickness) ? base : softest;
    least = std::min(least, modulus);
  }
  if (std::isinf(base)) return 0.0;
  return std::min(1.0, softest / base);
}

void validate(const RollingPair& pair) {
  std::visit([](const auto& shape) { viscoroll::validate(shape); }, pair.body);
  std::visit([](const auto& shape) { viscoroll::validate(shape); }, pair.on);
  if (!is_roller(pair.body) && std::holds_alternative<CoatedCylinder>(pair.on)) {
    reject("on", "a CoatedPlane or a Groove for a CoatedSphere", "a CoatedCylinder");
  }
  if (is_roller(pair.body) && std::holds_alternative<Groove>(pair.on)) {
    reject("on", "a CoatedPlane or a CoatedCylinder for a CoatedCylinder", "a Groove");
  }
  if (layers(pair).empty()) {
    reject("layers", "a list of at least one layer, of what rolls or of what it rolls on (on.layers), or on.base given",
           "none: two rigid bodies");
  }
  const TrackCurvature track = track_curvature(pair.on);
  const double radius = outer_radius(pair.body);
  const auto require_room = [radius](const char* name, double curvature) {
    if (radius * curvature < kClosestFit) return;
    reject(name, "larger than the ball's radius, " + text(radius) + " m, by 2 % at the least",
           text(1.0 / curvature) + " m");
  };
  require_room("on.radius", track.across);
  require_room("on.path_radius", track.along);
}

}  // namespace viscoroll::detail
