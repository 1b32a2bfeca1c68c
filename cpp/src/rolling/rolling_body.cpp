#include "rolling/rolling_body.hpp"

#include <limits>

#include "modal/harmonic_plane.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

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
  if (const auto* plane = std::get_if<CoatedPlane>(&on)) return viscoroll::is_rigid(*plane);
  return std::get<CoatedCylinder>(on).layers.empty();
}

double radius_of(const Counterpart& on) {
  const auto* roller = std::get_if<CoatedCylinder>(&on);
  return roller == nullptr ? std::numeric_limits<double>::infinity() : viscoroll::outer_radius(*roller);
}

double relative_radius(const RollingPair& pair) {
  const double radius = outer_radius(pair.body);
  return radius / (1.0 + radius / radius_of(pair.on));
}

std::vector<NamedLayer> layers(const RollingPair& pair) {
  std::vector<NamedLayer> named;
  append(named, layers_of(pair.body), "");
  if (const auto* roller = std::get_if<CoatedCylinder>(&pair.on)) {
    append(named, roller->layers, "on.");
    return named;
  }
  const auto& plane = std::get<CoatedPlane>(pair.on);
  if (plane.base) named.push_back({.name = "on.base", .layer = layers_from_base(plane).front()});
  append(named, plane.layers, "on.");
  return named;
}

double thickness(const RollingPair& pair) {
  double sum = 0.0;
  for (const NamedLayer& named : layers(pair)) sum += named.layer.thickness;
  return sum;
}

void validate(const RollingPair& pair) {
  std::visit([](const auto& shape) { viscoroll::validate(shape); }, pair.body);
  std::visit([](const auto& shape) { viscoroll::validate(shape); }, pair.on);
  if (!is_roller(pair.body) && (std::holds_alternative<CoatedCylinder>(pair.on) || !is_rigid(pair.on))) {
    reject("on", "a rigid plane for a sphere", "something else");
  }
  if (layers(pair).empty()) {
    reject("layers", "at least one, of what rolls or of what it rolls on", "none: two rigid bodies");
  }
}

}  // namespace viscoroll::detail
