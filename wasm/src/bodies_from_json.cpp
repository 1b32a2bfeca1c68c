#include "bodies_from_json.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "modulus_from_json.hpp"

namespace viscoroll::wasm {
namespace {

constexpr auto kInnerBoundaries = std::to_array<Name<InnerBoundary>>({
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) {#name, InnerBoundary::name},
#include "viscoroll/inner_boundaries.def"
#undef VISCOROLL_INNER_BOUNDARY
});
constexpr auto kHubs = std::to_array<Name<Hub>>({{"straight", Hub::straight}, {"crowned", Hub::crowned}});
constexpr auto kSides = std::to_array<Name<Sides>>({{"free", Sides::free}, {"unbounded", Sides::unbounded}});

ShearModulus take_modulus(Table& table) {
  const Json& given = table.require("shear_modulus");
  return given.is_null() ? ShearModulus{} : modulus_from_json(given, table.path_of("shear_modulus"));
}

Layer layer_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  Layer layer{.thickness = table.number("thickness"),
              .shear_modulus = take_modulus(table),
              .poisson_ratio = table.maybe_number("poisson_ratio"),
              .bulk_modulus = table.maybe_number("bulk_modulus"),
              .density = table.maybe_number("density").value_or(Layer{}.density)};
  // Case files may contain the conductivity for temperatures, which this module does not compute.
  (void)table.maybe_number("conductivity");
  table.close();
  at_path(path, [&] { validate(layer, ""); });
  return layer;
}

std::vector<Layer> take_layers(Table& table) {
  const Json* given = table.take("layers");
  if (given == nullptr) return {};
  const std::string path = table.path_of("layers");
  if (!given->is_array()) {
    throw InvalidInput(path, "must be a valid list", shown(*given));
  }
  std::vector<Layer> layers;
  layers.reserve(given->size());
  for (const Json& layer : *given) {
    layers.push_back(layer_from_json(layer, path + "[" + std::to_string(layers.size()) + "]"));
  }
  return layers;
}

std::optional<HalfSpace> take_base(Table& table) {
  const Json* given = table.take("base");
  if (given == nullptr) return std::nullopt;
  Table of_base(*given, table.path_of("base"));
  HalfSpace base{.shear_modulus = take_modulus(of_base),
                 .poisson_ratio = of_base.maybe_number("poisson_ratio"),
                 .bulk_modulus = of_base.maybe_number("bulk_modulus"),
                 .density = of_base.maybe_number("density").value_or(HalfSpace{}.density)};
  of_base.close();
  at_path(of_base.path(), [&] { validate(CoatedPlane{.base = base}); });
  return base;
}

template <class Body>
Body closed(const Table& table, Body body) {
  table.close();
  at_path(table.path(), [&] { validate(body); });
  return body;
}

CoatedSphere ball_from_json(Table& table) {
  return closed(
      table,
      CoatedSphere{.core_radius = table.maybe_number("core_radius").value_or(CoatedSphere{}.core_radius),
                   .layers = take_layers(table),
                   .inner_boundary = table.one_of("inner_boundary", kInnerBoundaries, CoatedSphere{}.inner_boundary)});
}

CoatedCylinder cylinder_from_json(Table& table) {
  return closed(table, CoatedCylinder{.core_radius = table.number("core_radius"), .layers = take_layers(table)});
}

CoatedWheel wheel_from_json(Table& table) {
  return closed(table,
                CoatedWheel{.core_radius = table.number("core_radius"),
                            .layers = take_layers(table),
                            .width = table.number("width"),
                            .crown_radius = table.maybe_number("crown_radius").value_or(CoatedWheel{}.crown_radius),
                            .hub = table.one_of("hub", kHubs, CoatedWheel{}.hub),
                            .sides = table.one_of("sides", kSides, CoatedWheel{}.sides)});
}

CoatedPlane take_plane(Table& table) { return {.layers = take_layers(table), .base = take_base(table)}; }

CoatedPlane plane_from_json(Table& table) { return closed(table, take_plane(table)); }

Groove groove_from_json(Table& table) {
  return closed(table, Groove{.radius = table.maybe_number("radius"),
                              .path_radius = table.maybe_number("path_radius"),
                              .surface = take_plane(table)});
}

template <class Kind, auto kFromJson>
Kind made(Table& table) {
  return kFromJson(table);
}

constexpr auto kBodies = std::to_array<Name<RollingBody (*)(Table&)>>({
    {"ball", made<RollingBody, ball_from_json>},
    {"cylinder", made<RollingBody, cylinder_from_json>},
    {"wheel", made<RollingBody, wheel_from_json>},
});
constexpr auto kCounterbodies = std::to_array<Name<Counterbody (*)(Table&)>>({
    {"plane", made<Counterbody, plane_from_json>},
    {"groove", made<Counterbody, groove_from_json>},
    {"other_ball", made<Counterbody, ball_from_json>},
    {"other_cylinder", made<Counterbody, cylinder_from_json>},
    {"other_wheel", made<Counterbody, wheel_from_json>},
});

template <class Kind, std::size_t kCount>
std::vector<Name<Kind>> take_given(Table& file, const std::array<Name<Kind (*)(Table&)>, kCount>& kinds) {
  std::vector<Name<Kind>> given;
  for (const auto& [name, from_json] : kinds) {
    const Json* content = file.take(name);
    if (content == nullptr) continue;
    Table table(*content, file.path_of(name));
    given.push_back({name, from_json(table)});
  }
  return given;
}

}  // namespace

Pair pair_from_json(Table& file) {
  auto bodies = take_given(file, kBodies);
  auto counterbodies = take_given(file, kCounterbodies);
  if (bodies.size() != 1) {
    throw std::invalid_argument("exactly one of " + names_of(kBodies) + " must be given, got " +
                                (bodies.empty() ? "none" : names_of(bodies, " and ")));
  }
  if (counterbodies.size() > 1) {
    throw std::invalid_argument("at most one of " + names_of(kCounterbodies) + " may be given, got " +
                                names_of(counterbodies, " and "));
  }
  Pair pair{.body = std::move(bodies.front().value), .on = CoatedPlane{}};
  if (!counterbodies.empty()) pair.on = std::move(counterbodies.front().value);
  return pair;
}

}  // namespace viscoroll::wasm
