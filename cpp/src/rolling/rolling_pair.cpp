#include "rolling/rolling_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "validate.hpp"

namespace viscoroll::detail {
namespace {

template <class... Shapes>
Body checked_body(const std::variant<Shapes...>& any) {
  return std::visit(
      [](const auto& shape) {
        validate(shape);
        return make_body(shape);
      },
      any);
}

void require_counterpart(const Body& body, const Body& on) {
  std::string all;
  for (const std::string_view type : body.counterparts) {
    if (type == on.type) return;
    all += (all.empty() ? "a " : " or a ") + std::string(type);
  }
  reject("on", all + " for a " + std::string(body.type), "a " + std::string(on.type));
}

}  // namespace

RollingPair rolling_pair(const RollingBody& body, const Counterpart& on) {
  RollingPair pair{.body = checked_body(body), .on = checked_body(on)};
  require_counterpart(pair.body, pair.on);
  if (pair.body.is_rigid() && pair.on.is_rigid()) {
    reject("layers", "a list of at least one layer, of what rolls or of what it rolls on (on.layers), or on.base given",
           "none: two rigid bodies");
  }
  pair.on.require_room_for(pair.body);
  return pair;
}

double relative_radius(const RollingPair& pair) {
  return pair.body.radius / (1.0 + pair.body.radius * pair.on.curvatures.along);
}

double width(const RollingPair& pair) { return std::min(pair.body.width, pair.on.width); }

std::vector<NamedLayer> layers(const RollingPair& pair) {
  std::vector<NamedLayer> all = pair.body.layers;
  for (const auto& [name, layer] : pair.on.layers) all.push_back({.name = "on." + name, .layer = layer});
  return all;
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

}  // namespace viscoroll::detail
